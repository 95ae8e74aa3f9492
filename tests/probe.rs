#[path = "support/power_series.rs"]
mod power_series;
use power_series::*;
use spinning_bodies::frame::*;
use spinning_bodies::kovalevskaya_top::*;
type V = BodyVector;
fn try_one(name: &str, c: f64, o: [f64; 3], z: [f64; 3]) {
    let top = match KovalevskayaTop::with_up([2.0, 2.0, 1.0], V::new(c, 0.0, 0.0), V::new(o[0], o[1], o[2]), V::new(z[0], z[1], z[2])) { Ok(t) => t, Err(e) => { println!("{name}: {e}"); return; } };
    let s0 = top.at(0.0).unwrap();
    let q = s0.attitude.quaternion();
    let y = [o[0], o[1], o[2], s0.up.x(), s0.up.y(), s0.up.z(), q.w, q.i, q.j, q.k];
    let r = Top { moments: [2.0, 2.0, 1.0], lever: [c, 0.0, 0.0] };
    print!("{name}: {:?} {:?} {:?} ", top.kind(), top.method(), top.frequencies());
    for t in [1.0, 10.0, 100.0] {
        let s = top.at(t).unwrap();
        let w = r.after(y, t);
        let e = (0..3).map(|i| (s.omega.components()[i] - w[i]).abs().max((s.up.components()[i] - w[3 + i]).abs())).fold(0.0, f64::max);
        let a = Attitude::from_quaternion(w[6], w[7], w[8], w[9]).unwrap().angle_to(&s.attitude);
        let so = top.omega_and_up(t).unwrap();
        let ez = (so.omega - s.omega).norm();
        print!(" {e:.1e}/{a:.1e}/{ez:.0e}");
    }
    println!();
}
#[test]
fn probe() {
    try_one("ref", 1.0, [1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
    try_one("claim", 1.0, [1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    try_one("q0", 1.0, [1.0, 0.0, 0.3], [0.6, 0.48, 0.64]);
    try_one("q0z2 0", 1.0, [1.0, 0.0, 0.3], [0.6, 0.0, 0.8]);
    try_one("rest", 1.0, [0.0, 0.0, 0.0], [0.6, 0.48, 0.64]);
    try_one("rest plane", 1.0, [0.0, 0.0, 0.0], [0.6, 0.0, 0.8]);
    try_one("rest plane3", 1.0, [0.0, 0.0, 0.0], [0.6, 0.8, 0.0]);
    try_one("delaunay", 1.0, [1.0, 0.0, 0.7], [1.0, 0.0, 0.0]);
    try_one("delaunay2", 1.0, [0.8, 0.6, 0.7], [0.28, 0.96, 0.0]);
    try_one("delaunay3", 1.0, [0.4, 0.3, 0.7], [0.07, 0.24, (1.0f64-0.07*0.07-0.24*0.24).sqrt()]);
    try_one("delaunay 0,0,w", 1.0, [0.0, 0.0, 0.7], [0.0, 0.0, 1.0]);
    try_one("hang", 1.0, [0.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    try_one("hang spin", 1.0, [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    try_one("upright", 1.0, [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    try_one("upright spin", 1.0, [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    try_one("upright nearly", 1.0, [2.0, 1e-6, 0.0], [1.0, 0.0, 0.0]);
    try_one("hang nearly", 1.0, [0.5, 1e-6, 0.0], [-1.0, 0.0, 0.0]);
    try_one("pendulum 2", 1.0, [0.0, 0.7, 0.0], [0.6, 0.0, 0.8]);
    try_one("pendulum 3", 1.0, [0.0, 0.0, 0.7], [0.6, 0.8, 0.0]);
    try_one("l=0", 1.0, [0.7, 0.3, 0.5], [0.0, 0.0, 0.0]);
    try_one("l=0", 1.0, [1.0, 0.5, 0.0], [0.5, -1.0, 0.7]);
    for c in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-16, 1e-300, 0.0, 10.0, 1e4, 1e8] {
        try_one(&format!("c {c:e}"), c, [1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    }
}
