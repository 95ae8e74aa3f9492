//! What a thrown body conserves (tutorial 3.2, 3.3): L of a brick in the air, about which Ω moves.

use nalgebra::UnitQuaternion;
use spinning_bodies::conservation::uniform_gravity;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::inertia::{PlatonicSolid, shapes};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[of("thrown-brick", &[OFF, TURNS], thrown_brick)];

/// A brick, kg and m.
const MASS: f64 = 3.0;
const EDGES: [f64; 3] = [0.24, 0.115, 0.071];
/// Seconds in the air, and the velocity at the throw along the page, m/s.
const FLIGHT: f64 = 0.9;
const THROWN: f64 = 2.15;
/// Pictures of the brick.
const PICTURES: u32 = 7;

parameters! {
    OFF: "off", r"\alpha", "°", "angle of Ω from the middle axis at the throw, towards the long one", [0.0, 90.0], 20.0;
    TURNS: "turns", "n", "turns/s", "spin at the throw", [0.5, 3.0], 1.5;
}
/// A brick on its parabola, with L and Ω at equal times.
pub fn thrown_brick(values: &Values) -> Result<Figure> {
    let [off, turns] = values.each([OFF, TURNS]);
    let body = shapes::cuboid(MASS, EDGES)?;
    let (sin, cos) = off.to_radians().sin_cos();
    let omega = BodyVector::new(sin, cos, 0.0) * (TAU * turns);
    let l = body.inertia().angular_momentum(omega);
    // L points upwards, and the long edge as far to the right as it can.
    let upright = UnitQuaternion::rotation_between(&l.components(), &Vector::z());
    let upright = upright.unwrap_or_default().into_inner();
    let start = Attitude::from_quaternion(upright.w, upright.i, upright.j, upright.k)?;
    let moments = body.inertia().principal_axes().moments;
    let top = EulerTop::from_omega(moments, omega, start)?;
    let ground = SpaceVector::zero();
    let weight = uniform_gravity(MASS, ground, ground, SpaceVector::new(0.0, 0.0, -9.81))?;
    let fall = weight.force.components() / MASS;
    let thrown = Vector::new(0.0, THROWN, 0.0) - 0.5 * FLIGHT * fall;
    let times = spaced([0.0, FLIGHT], 180);
    let rows = tried(times.clone(), |t| {
        let state = top.at(t)?;
        let space = |v| state.attitude.to_space(v).components();
        let place = t * thrown + 0.5 * t * t * fall;
        let arrows = [space(state.angular_momentum), space(state.omega)];
        Ok((state.attitude, place, arrows))
    })?;
    let leans = rows
        .iter()
        .map(|(.., [l, omega])| l.angle(omega).to_degrees());
    let [least, most] = extent(leans);
    let told = numbers([least, most], 1);
    let claim = match most < 0.05 {
            true => "Thrown exactly about a principal axis, the brick keeps its angular momentum, and its angular velocity stays with it.".to_owned(),
            false => format!(
                "In the air the brick keeps its angular momentum; its angular velocity wanders, between {}° and {}° from it.",
                told[0], told[1]
            ),
        };
    let [low, high] = &told;
    let [long, middle, thin] = EDGES.map(|edge| short(1e2 * edge, 1));
    let [spun, lean] = briefs([turns, off]);
    let apart = short(FLIGHT / f64::from(PICTURES - 1), 3);
    let words = words!(
        "{claim}",
        "A brick of {long} by {middle} by {thin} cm, thrown with {spun} turns a second about an axis {lean}° off its middle one, every {apart} s. Its centre follows the parabola of a thrown stone, \
         and about the centre gravity has no torque. Orange: $L$, the same seven times; blue: $\\Omega$, each to its own scale.",
        "Seven pictures of a tumbling brick along a parabola. From each centre an orange arrow, the angular momentum, points straight up, always of one length. Beside it a blue \
         arrow, the angular velocity, {low} to {high} degrees from the orange one."
    );
    let solid = PlatonicSolid::Cube;
    let corners = solid.vertices(1.0)?;
    let page = View::new(0.0, 0.3, [78.0, 352.0], 206.0);
    let greatest = rows.iter().map(|row| row.2[1].norm()).fold(0.0, f64::max);
    let made = figure("thrown-brick", 420.0, words, |pen| {
        let path: Vec<Point> = rows.iter().map(|row| page.project(&row.1)).collect();
        pen.line(&path, muted(AXIS).dotted());
        let mut arrows = Vec::new();
        for k in 0..PICTURES {
            let (attitude, place, [l, omega]) = &rows[(180 / (PICTURES - 1) * k) as usize];
            let center = page.project(place);
            let view = View::new(0.0, 0.3, center, page.scale());
            polyhedron(pen, &view, &solid.faces(), |k| {
                let corner = Vector::from(corners[k as usize]);
                turned(attitude, corner.component_mul(&Vector::from(EDGES)))
            });
            let tips =
                [l.normalize() * 0.36, omega * (0.34 / greatest)].map(|tip| view.project(&tip));
            arrows.push((center, tips));
        }
        let roles = [(AngularMomentum, 2.6, "*L*"), (Omega, DATA, "*Ω*")];
        for (center, tips) in &arrows {
            for (tip, (role, width, _)) in tips.iter().zip(roles) {
                pen.arrow(*center, *tip, stroke(role, width));
            }
        }
        for (_, tips) in arrows.iter().step_by(3) {
            for (tip, (role, _, name)) in tips.iter().zip(roles) {
                let around = (0..24).map(|k| polar(*tip, 17.0, 0.262 * f64::from(k)));
                pen.name(around, name, label(role));
            }
        }
        let text = format!("{} s", short(FLIGHT, 2));
        pen.remark([path[180][0], 412.0], Middle, &text);
        pen.remark([path[0][0], 412.0], Middle, "0 s");
    });
    let columns = "time (s) | L_x (kg m²/s) | L_y (kg m²/s) | L_z (kg m²/s) | Ω_x (rad/s) | Ω_y (rad/s) | Ω_z (rad/s)";
    let table = times.zip(&rows).map(|(t, (.., [l, omega]))| {
        let numbers = l.iter().chain(omega.iter()).copied();
        core::iter::once(t).chain(numbers).collect::<Vec<_>>()
    });
    let [least, most] = told;
    Ok(made
        .data("brick", columns, table)
        .value("least", least)
        .value("most", most))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eight point masses with the inertia of the brick, by Newton's laws: L and energy at the throw equal those of every row.
    #[test]
    fn eight_masses_keep_what_the_brick_keeps() {
        let (s, c) = 20_f64.to_radians().sin_cos();
        let omega = Vector::new(s, c, 0.0) * 1.5 * TAU;
        let half = Vector::from(EDGES) / 12_f64.sqrt();
        let l: Vector = (0..8)
            .map(|k| Vector::from_fn(|i, _| f64::from((k >> i & 1) * 2 - 1) * half[i]))
            .map(|x| x.cross(&omega.cross(&x)) * MASS / 8.0)
            .sum();
        let figure = thrown_brick(&Values::default()).expect("a figure");
        for (_, row) in &figure.data.rows {
            let [now, turning] = [1, 4].map(|k| Vector::new(row[k], row[k + 1], row[k + 2]));
            let off = now - Vector::z() * l.norm();
            assert!(off.norm() < 1e-14 * l.norm(), "{off}");
            let energy = now.dot(&turning) / l.dot(&omega) - 1.0;
            assert!(energy.abs() < 1e-13, "{energy:e}");
        }
        assert!(figure.claim.contains("wanders"));
        for end in [0.0, 90.0] {
            let values = Values::default().with(&OFF, end).expect("an end");
            let claim = thrown_brick(&values).expect("a figure").claim;
            assert!(claim.contains("stays with it"), "{claim}");
        }
    }
}
