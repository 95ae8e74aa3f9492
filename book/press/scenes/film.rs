//! A motion as a film of the moving body, `--film`, or as stills, `--frames`.

use std::f64::consts::FRAC_PI_2;
use std::ffi::OsStr;
use std::path::Path;

use figures::film::Film;
use nalgebra::{UnitQuaternion, Vector3};
use spinning_bodies::scene::Sight;

use super::{Motion, stem};
use crate::pictures::{Form, can_be_made, file};
use crate::progress::counted;
use crate::writer::{can_be_written_into, ending, folder_of, followed, several, tell, whole};
use crate::{Error, Result, error::one_line};

/// The film of a motion in `count` pictures at equal steps from the first of its times to the last. The motion must have all of its columns.
fn filmed<'a>(motion: &Motion, title: &'a str, count: usize, speed: f64) -> Result<Film<'a>> {
    let sights = |count: usize| {
        let table = motion.evenly(count)?;
        let sight = |(time, row): (f64, Vec<f64>)| {
            let sight = motion.scene.sight(&table.columns, &row);
            sight.map(|sight| (time, sight))
        };
        Ok::<Vec<(f64, Sight)>, Error>(table.rows().filter_map(sight).collect())
    };
    let mut shots = sights(count)?;
    if shots.iter().any(|(_, sight)| !sight.turned) {
        // Only the rate of the angle is known, so it is summed up in between.
        shots = turned(sights((count - 1) * BETWEEN + 1)?);
    }
    Ok(Film {
        title,
        speed,
        shots,
    })
}

/// Steps from one picture to the next, where an angle is summed up.
const BETWEEN: usize = 16;

/// One shot of [`BETWEEN`], its solids turned as far as Ω has turned them.
fn turned(shots: Vec<(f64, Sight)>) -> Vec<(f64, Sight)> {
    let mut angle = Vector3::zeros();
    let mut before: Option<(f64, Vector3<f64>)> = None;
    let turn = |(time, mut sight): (f64, Sight)| {
        if let Some((then, omega)) = before.replace((time, sight.omega)) {
            angle += (omega + sight.omega) * (0.5 * (time - then));
        }
        let about = UnitQuaternion::from_scaled_axis(angle);
        for (_, stands) in &mut sight.solids {
            stands.append_rotation_wrt_point_mut(&about, &sight.place.into());
        }
        (time, sight)
    };
    shots.into_iter().map(turn).step_by(BETWEEN).collect()
}

/// Pictures in a second of a film, and most bytes of one.
const PER_SECOND: f64 = 25.0;
const MOST_BYTES: f64 = 390_000.0;
/// Number of trial pictures that are drawn to find their size.
const TRIED: usize = 12;
/// Default duration of a film, and its limits, s.
const LASTS: f64 = 10.0;
const MAY_LAST: [f64; 2] = [1.0, 60.0];

/// Runs a scene, which must have all of its columns, and films it, with a warning if it turns too fast for the pictures.
///
/// # Errors
/// [`Error::Input`] for a single time and for a speed at which the film would be too short or too long; those of [`run`](Motion::run).
pub fn film(motion: &Motion, speed: Option<f64>) -> Result<Vec<u8>> {
    let span = motion.span("--film")?;
    let speed = speed.unwrap_or(span / LASTS);
    let seconds = span / speed;
    let [shortest, longest] = MAY_LAST;
    if !(shortest..=longest).contains(&seconds) {
        let [slow, fast] = [longest, shortest].map(|seconds| span / seconds);
        return Err(Error::Input(format!(
            "--speed: {} lasts {span:?} s, expected a speed from {slow:.3e} to {fast:.3e}, got {speed:?}: a film takes from {shortest} s to {longest} s",
            motion.name
        )));
    }
    let title = &stem(&motion.name);
    // The size of a few pictures decides how many there may be.
    let bytes = filmed(motion, title, TRIED, speed)?.film(seconds).len();
    let room = MOST_BYTES / bytes as f64 * TRIED as f64;
    let count = room.min(PER_SECOND * seconds).max(2.0) as usize;
    let film = filmed(motion, title, count, speed)?;
    let speeds = film.shots.iter().map(|(_, sight)| sight.omega.norm());
    let fastest = speeds.fold(0.0, f64::max);
    let between = fastest * span / (count - 1) as f64;
    if between > FRAC_PI_2 {
        tell(one_line(&format!(
            "warning: {}: it turns by up to {between:.1} rad from one picture to the next, too fast for the eye; a smaller --speed or a shorter run would show it",
            motion.name
        )));
    }
    Ok(film.film(seconds).into_bytes())
}

/// Most stills.
const MOST_STILLS: usize = 10_000;

/// Runs a scene, which must have all of its columns, and draws this many pictures of it into a folder, at equal steps of time: at the end the folder is
/// complete, or absent. The option is checked before the scene is read.
///
/// # Errors
/// [`Error::Input`] for an invalid number, and for a folder that is not empty or not a folder; [`Error::File`]; as for [`file`](file()) and
/// [`run`](Motion::run).
pub fn stills(
    folder: &Path,
    count: &OsStr,
    form: Form,
    motion: impl FnOnce() -> Result<Motion>,
) -> Result<String> {
    let refused = |told: String| Err(Error::Input(format!("--frames: {told}")));
    let number = count.to_str().and_then(|count| count.parse().ok());
    let Some(count) = number.filter(|count| (1..=MOST_STILLS).contains(count)) else {
        let count = count.display();
        return refused(format!(
            "N is '{count}', expected a whole number from 1 to {MOST_STILLS}"
        ));
    };
    can_be_made(form)?;
    let empty = std::fs::read_dir(folder).map(|mut inside| inside.next().is_none());
    let is_stream = folder == Path::new("-");
    if is_stream || folder.file_name().is_none() || folder.exists() && !empty.unwrap_or(false) {
        let folder = folder.display();
        return refused(format!(
            "DIR is '{folder}', expected an empty folder or a new one"
        ));
    }
    let place = &followed(folder).map_err(Error::file(folder))?;
    can_be_written_into(folder_of(place))?;
    let motion = motion()?;
    if count > 1 {
        motion.span("--frames")?;
    }
    let title = stem(&motion.name);
    let film = filmed(&motion, &title, count, 1.0)?;
    whole(place, |stills| {
        std::fs::create_dir(stills).map_err(Error::file(folder))?;
        let digits = count.to_string().len();
        counted(count, "stills", |done| {
            film.stills().enumerate().try_for_each(|(k, figure)| {
                let name = format!("{:0digits$}.{}", k + 1, ending(&form));
                let written = std::fs::write(stills.join(&name), file(&figure, form.into())?);
                done();
                // Named is what was asked for, not where it is made.
                written.map_err(Error::file(&folder.join(name)))
            })
        })?;
        // One that was empty gives way if it is so still.
        match place.exists() {
            true => std::fs::remove_dir(place).map_err(Error::file(folder)),
            false => Ok(()),
        }
    })?;
    let stills = several(count, "still");
    Ok(format!("{stills} in {}\n", folder.display()))
}
