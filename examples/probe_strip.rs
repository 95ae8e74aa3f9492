//! x
use spinning_bodies::falling_strip::*;
fn main(){
 for (c,is) in [(Coefficients::PUBLISHED,vec![0.5,0.8,1.0,1.1,1.2,1.3,1.4,1.45,1.6,2.2,3.0,4.0]),(Coefficients::PAPER,vec![0.3,0.4,0.5,0.515,0.525])] {
 for i in is {
 let f=Fall::new(i,c).unwrap();
 let times:Vec<f64>=(0..8000).map(|k|k as f64*0.1).collect();
 let p=f.path(Start::TILTED,&times).unwrap();
 let m=p[4000..].iter().map(|s|s[2]).fold(f64::MIN,f64::max)-p[4000..].iter().map(|s|s[2]).fold(f64::MAX,f64::min);
 println!("{i} range/2 {} {:?}",m/2.0, f.long_run(Start::TILTED,400.0,400.0).unwrap());
 }}
}
