use spinning_bodies::falling_strip::*;
fn main(){
 for i in [0.5,0.8,1.0,1.1,1.15,1.2,1.21,1.3,1.4,1.45,1.6,2.2,3.0,4.0] {
  let f=Fall::new(i,Coefficients::PUBLISHED).unwrap();
  let t=std::time::Instant::now();
  for s in [Start::TILTED,Start::SPINNING]{
  let r=f.long_run(s,400.0,400.0).unwrap();
  println!("{i} {r:?} {:?}",t.elapsed());}
 }
 for i in [0.4,0.5,0.53,0.54,0.6,1.0,2.0,4.0,8.0,16.0] {
  let f=Fall::new(i,Coefficients::PAPER).unwrap();
  let r=f.long_run(Start::TILTED,400.0,400.0).unwrap();
  println!("paper {i} {r:?} {} {}",r.glide_angle().to_degrees(), r.rotation.abs()/r.drift.hypot(r.descent));
 }
 let t=std::time::Instant::now();
 println!("{:?} {:?}",transition(Coefficients::PUBLISHED,1.1,1.3,1e-5,600.0),t.elapsed());
 println!("{:?}",transition(Coefficients::PAPER,0.4,0.54,1e-5,600.0));
}
