//! What the tests share: bounds with two sides.

use core::fmt::Arguments;
use core::ops::RangeInclusive;
use std::fs;
use std::path::Path;
use std::sync::Mutex;

/// An error within what was observed: asserted to be no greater than the upper end.
///
/// The lower end is for the greatest error that the line ever sees. Where the environment sets `REFERENCE_PLATFORM` it is written to
/// `target/tmp/observed`, one file a line, and `.ci/run` looks there for errors that have become much smaller than their bound: a bound that
/// no longer bites is brought down, or tells that the test no longer tests. On another processor, or with another libm, only the upper end counts.
#[macro_export]
macro_rules! observed {
    ($error:expr, $range:expr $(,)?) => {
        $crate::observed!($error, $range, "")
    };
    ($error:expr, $range:expr, $($told:tt)+) => {{
        static GREATEST: $crate::Greatest =
            $crate::Greatest::at(env!("CARGO_TARGET_TMPDIR"), module_path!(), line!());
        GREATEST.see($error, $range, format_args!($($told)+));
    }};
}

/// The greatest error that a line of a test has seen.
#[derive(Debug)]
pub struct Greatest {
    folder: &'static str,
    module: &'static str,
    line: u32,
    seen: Mutex<Option<f64>>,
}

impl Greatest {
    /// Of this line.
    pub const fn at(folder: &'static str, module: &'static str, line: u32) -> Self {
        Self {
            folder,
            module,
            line,
            seen: Mutex::new(None),
        }
    }

    /// Takes notice of an error.
    ///
    /// # Panics
    /// If it is above the range, or not a number.
    #[track_caller]
    pub fn see(&self, error: f64, range: RangeInclusive<f64>, told: Arguments<'_>) {
        let (least, most) = range.into_inner();
        assert!(error <= most, "{error:e} is above {most:e} {told}");
        if std::env::var_os("REFERENCE_PLATFORM").is_none() {
            return;
        }
        let mut seen = self
            .seen
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        if seen.is_none_or(|before| error > before) {
            *seen = Some(error);
            let folder = Path::new(self.folder).join("observed");
            let name = format!("{}-{}", self.module.replace("::", "-"), self.line);
            let line = format!("{least:e} {error:e} {most:e}\n");
            let written =
                fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join(name), line));
            assert!(written.is_ok(), "{written:?}");
        }
    }
}

/// How far two numbers that should be equal are apart, over the greater of them; 0 if both are 0.
pub fn relative(a: f64, b: f64) -> f64 {
    if a == b {
        0.0
    } else {
        (a - b).abs() / a.abs().max(b.abs())
    }
}
