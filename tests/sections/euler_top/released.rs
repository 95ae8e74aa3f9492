//! Bodies from scratch, side by side (6.6, 6.8): those of `EulerTop::new` and `at`, one body at a time. That both are right, the
//! table of 32 digits says in `tests/hard_cases/free_top.rs`.

use spinning_bodies::Error;
use spinning_bodies::euler_top::{Ensemble, EulerTop, Release, State, released_states};
use support::{Uniform, refused, vector};

use super::common::random_start;

fn release(moments: [f64; 3], l: [f64; 3], numbers: &mut Uniform) -> Release {
    Release {
        moments,
        angular_momentum: vector(l),
        attitude: numbers.attitude(),
    }
}

/// The bodies at these times, all at once and from an ensemble, those of one at a time to the last bit.
fn agree(releases: &[Release], times: &[f64]) {
    let ensemble = Ensemble::released(releases.to_vec()).unwrap();
    let mut states = vec![State::default(); releases.len()];
    let mut kept = states.clone();
    for t in times {
        released_states(releases, *t, &mut states).unwrap();
        ensemble.states_at(*t, &mut kept).unwrap();
        for (release, state) in releases
            .iter()
            .chain(releases)
            .zip(states.iter().chain(&kept))
        {
            let top = EulerTop::new(release.moments, release.angular_momentum, release.attitude);
            let alone = top.unwrap().at(*t).unwrap();
            assert_eq!(alone, *state);
        }
    }
}

/// Any bodies.
fn any_releases(count: usize, numbers: &mut Uniform) -> Vec<Release> {
    let any = |_| {
        let (moments, l) = random_start(numbers);
        release(moments, l, numbers)
    };
    (0..count).map(any).collect()
}

/// Up to where they reach side by side, and beyond.
const TIMES: [f64; 5] = [0.0, 12.25, -1e5, 3e6, 1e9];

#[test]
fn s6_6_any_bodies_from_scratch() {
    let mut numbers = Uniform(71);
    let releases = any_releases(1500, &mut numbers);
    agree(&releases, &TIMES);
    // Of every kind too few, and none at all.
    for count in [0, 1, 2, 7, 9] {
        agree(&releases[..count], &TIMES);
    }
}

#[test]
fn s6_6_hard_cases_from_scratch() {
    let mut numbers = Uniform(72);
    let mut releases = Vec::new();
    for k in 0..320 {
        let signed = |numbers: &mut Uniform| 2.0 * numbers.next() - 1.0;
        let [x, y, z] = [0; 3].map(|_| signed(&mut numbers));
        let tiny = |n: i32| 10f64.powi(-(k % n));
        // Rackets ever nearer to the middle axis.
        releases.push(release(
            [1.0, 2.0, 3.0],
            [x * tiny(17), 1.0, z * tiny(17)],
            &mut numbers,
        ));
        // On the separatrix and so many units in the last place beside it.
        let beside = f64::EPSILON * f64::from(k % 21 - 10) * 10f64.powi(k % 13);
        releases.push(release(
            [1.5, 3.0, 4.0],
            [1.0, 0.5 * y, 2.0 + beside],
            &mut numbers,
        ));
        // Symmetric, nearly so, nearly spheres, spheres.
        releases.push(release([1.3, 1.3, 1.0 + x.abs()], [x, y, z], &mut numbers));
        releases.push(release([1.3, 1.3 + tiny(17), 1.9], [x, y, z], &mut numbers));
        releases.push(release(
            [1.0, 1.0 + tiny(17), 1.0 + x.abs() * tiny(17)],
            [y, z, x],
            &mut numbers,
        ));
        releases.push(release([y.abs() + 0.1; 3], [x, y, z], &mut numbers));
        // One component small, zero, or so small that there is no room side by side; the axis itself.
        let mut l = [x, y, z];
        l[(k % 3) as usize] *= 10f64.powi(-(k % 40));
        releases.push(release([0.6, 0.8, 1.0], l, &mut numbers));
        l[(k % 3) as usize] = 0.0;
        releases.push(release([0.8, 1.0, 0.6], l, &mut numbers));
        l[(k + 1) as usize % 3] = 0.0;
        releases.push(release([0.8, 1.0, 0.6], l, &mut numbers));
        // Laminae, rods, and one at rest.
        releases.push(release([3.0, 1.0, 2.0], [x, y, z], &mut numbers));
        releases.push(release([1.0, 0.0, 1.0], [x, 0.0, z], &mut numbers));
        releases.push(release([1.0, 2.0, 3.0], [0.0; 3], &mut numbers));
    }
    agree(&releases, &TIMES[..4]);
}

#[test]
fn s6_6_bodies_of_any_size_from_scratch() {
    let mut numbers = Uniform(73);
    let mut releases = Vec::new();
    for k in -8..8 {
        for n in -8..8 {
            let (moments, l) = random_start(&mut numbers);
            let (size, pace) = (10f64.powi(17 * k), 10f64.powi(n));
            releases.push(release(
                moments.map(|x| x * size),
                l.map(|x| x * pace * size),
                &mut numbers,
            ));
        }
    }
    agree(&releases, &[0.0, 1e-3, 1e3]);
}

#[test]
fn s6_6_a_refused_body_is_named_by_its_place() {
    let mut numbers = Uniform(74);
    let good = release([1.0, 2.0, 2.5], [0.3, 0.4, 0.5], &mut numbers);
    let mut states = [State::default(); 12];
    for (moments, l) in [
        ([1.0, 2.0, 3.5], [1.0, 2.0, 3.0]),
        ([1.0, -2.0, 2.0], [1.0, 2.0, 3.0]),
        ([1.0, f64::NAN, 2.0], [1.0, 2.0, 3.0]),
        ([1.0, 2.0, 2.0], [1.0, f64::INFINITY, 3.0]),
        ([1.0, 2.0, 2.0], [1.0, f64::NAN, 3.0]),
        ([0.0, 2.0, 2.0], [1.0, 2.0, 3.0]),
        ([1e-300, 1e-300, 1e-300], [1e10, 2e10, 3e10]),
    ] {
        for at in [0, 5, 11] {
            let mut releases = [good; 12];
            releases[at] = release(moments, l, &mut numbers);
            let alone = EulerTop::new(moments, vector(l), releases[at].attitude).unwrap_err();
            let both = [
                Ensemble::released(releases.to_vec()).map(|_| ()),
                released_states(&releases, 1.0, &mut states),
            ];
            for result in both {
                match result {
                    Err(Error::AtPlace { place, reason }) => {
                        assert_eq!(place, at);
                        assert_eq!(reason.to_string(), alone.to_string());
                    }
                    other => panic!("{other:?}"),
                }
            }
        }
    }
    refused!(released_states(&[good; 3], 0.0, &mut states), Condition);
    for t in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(released_states(&[good; 12], t, &mut states).is_err());
    }
}
