//! A motion as the moving body itself: `--film`, and as stills of it: `--frames`.

use std::f64::consts::FRAC_PI_2;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use figures::film::Film;
use nalgebra::{UnitQuaternion, Vector3};
use spinning_bodies::scene::Sight;

use super::output::Motion;
use crate::interrupt::Unfinished;
use crate::pictures::{Copying, Form, file};
use crate::progress::counted;
use crate::writer::{can_be_written_into, folder_of, tell};
use crate::{Error, Result};

/// The motion at so many equal steps from the first of its times to the last, and the picture of it. The scene tells all of its columns.
fn filmed<'a>(motion: &'a Motion<'_>, count: usize, speed: f64) -> Result<Film<'a>> {
    let sights = |count: usize| {
        let [first, last] = motion.ends();
        let time = |k: usize| match k {
            0 => first,
            k if k + 1 == count => last,
            k => first + (last - first) * (k as f64 / (count - 1) as f64),
        };
        let table = motion.table(&(0..count).map(time).collect::<Vec<_>>())?;
        let sight = |(time, row): (f64, Vec<f64>)| {
            let sight = motion.scene.sight(&table.columns, &row);
            sight.map(|sight| (time, sight))
        };
        Ok::<Vec<(f64, Sight)>, Error>(table.rows().filter_map(sight).collect())
    };
    let mut shots = sights(count)?;
    if shots.iter().any(|(_, sight)| !sight.turned) {
        // The angle is told by its rate only: it is summed up in between.
        shots = turned(sights((count - 1) * BETWEEN + 1)?);
    }
    let title = Path::new(motion.name).file_stem().unwrap_or_default();
    Ok(Film {
        title: title.to_str().unwrap_or("motion"),
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
/// Pictures that are drawn to see how large they are.
const TRIED: usize = 12;
/// How long a film lasts by itself, and may last, s.
const LASTS: f64 = 10.0;
const MAY_LAST: [f64; 2] = [1.0, 60.0];

/// Runs a scene, which tells all of its columns, and films it. Says so if it turns too fast for the pictures.
///
/// # Errors
/// [`Error::Input`] for a single time and for a speed at which the film would be too short or too long; what [`run`](super::run) says.
pub fn film(motion: &Motion<'_>, speed: Option<f64>) -> Result<Vec<u8>> {
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
    // A few of its pictures tell how many there may be.
    let bytes = filmed(motion, TRIED, speed)?.film(seconds).len();
    let room = MOST_BYTES / bytes as f64 * TRIED as f64;
    let count = room.min(PER_SECOND * seconds).max(2.0) as usize;
    let film = filmed(motion, count, speed)?;
    let speeds = film.shots.iter().map(|(_, sight)| sight.omega.norm());
    let fastest = speeds.fold(0.0, f64::max);
    let between = fastest * span / (count - 1) as f64;
    if between > FRAC_PI_2 {
        tell(format_args!(
            "warning: {}: it turns by up to {between:.1} rad from one picture to the next, which no eye can follow; a smaller --speed or a shorter run shows it",
            motion.name
        ));
    }
    Ok(film.film(seconds).into_bytes())
}

/// Most stills.
const MOST_STILLS: usize = 10_000;

/// How many stills go into which folder: `--frames DIR N`.
#[derive(Debug)]
pub struct Stills {
    folder: PathBuf,
    count: usize,
}

impl Stills {
    /// What stands after the option.
    ///
    /// # Errors
    /// [`Error::Input`] for a number that is none, and for a folder that has something in it, or is none.
    pub fn of(folder_and_count: &[OsString]) -> Result<Option<Self>> {
        let [folder, count] = folder_and_count else {
            return Ok(None);
        };
        let refused = |told: String| Error::Input(format!("--frames: {told}"));
        let number = count.to_str().and_then(|count| count.parse().ok());
        let Some(count) = number.filter(|count| (1..=MOST_STILLS).contains(count)) else {
            let count = count.display();
            let told = format!("N is '{count}', expected a whole number from 1 to {MOST_STILLS}");
            return Err(refused(told));
        };
        let folder = PathBuf::from(folder);
        let empty = std::fs::read_dir(&folder).map(|mut inside| inside.next().is_none());
        if folder.exists() && !empty.unwrap_or(false) {
            let folder = folder.display();
            return Err(refused(format!(
                "DIR is {folder}, expected an empty folder or a new one"
            )));
        }
        can_be_written_into(folder_of(&folder))?;
        Ok(Some(Self { folder, count }))
    }

    /// Runs a scene, which tells all of its columns, and draws it at equal steps of time. All of the folder is there at the end, or nothing.
    ///
    /// # Errors
    /// [`Error::File`]; as for [`file`](file()) and [`run`](super::run).
    pub fn draw(&self, motion: &Motion<'_>, form: Form) -> Result<String> {
        let Self { folder, count } = self;
        if *count > 1 {
            motion.span("--frames")?;
        }
        let film = filmed(motion, *count, 1.0)?;
        let parent = folder_of(folder);
        std::fs::create_dir_all(parent).map_err(Error::file(parent))?;
        let beside = Unfinished::folder(parent).map_err(Error::file(parent))?;
        let copying = Copying::of(form);
        let digits = count.to_string().len();
        counted(*count, "stills", |done| {
            for (k, figure) in film.stills().enumerate() {
                let name = format!("{:0digits$}.{}", k + 1, form.ending());
                let path = beside.path().join(name);
                std::fs::write(&path, file(&figure, copying)?).map_err(Error::file(&path))?;
                done();
            }
            Ok::<_, Error>(())
        })?;
        // An empty folder gives way.
        let _ = std::fs::remove_dir(folder);
        beside.become_file(folder).map_err(Error::file(folder))?;
        let stills = if *count == 1 { "still" } else { "stills" };
        Ok(format!("{count} {stills} in {}\n", folder.display()))
    }
}
