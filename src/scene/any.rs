//! Scenes whose kind is known only at run time, and their motions as tables of numbers.

use super::columns::Column;
use super::{Plan, Request, Scene, Tabulated};
use crate::conservation::Ledger;
use crate::error::Result;
use crate::integrators::Cost;

/// Runs a scene and returns the columns that are told.
type Simulation = dyn Fn(&AnyScene, &Request) -> Result<Table>;

/// A scene of any kind, and the columns it returns.
///
/// ```
/// use spinning_bodies::rolling::RoundBody;
/// use spinning_bodies::scene::{AnyScene, Request, Roller, effects::Coulomb};
///
/// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.4, 0.0)?;
/// let scene = AnyScene::scene(Box::new(ball.with(Coulomb::new(0.2)?)?));
/// let scene = scene.telling(&["rim_speed", "rotation"]).map_err(|unknown| unknown.to_string());
/// let table = scene.expect("two of its columns").simulate(&Request::at([5.0])?)?;
/// let (_, row) = table.row(0);
/// assert!((row[0] - 1.0).abs() < 1e-14); // it rolls at five sevenths of its speed
/// assert!((row[1] - 0.5 * 0.4 * 0.17).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub struct AnyScene {
    columns: Vec<Column>,
    told: Vec<usize>,
    simulation: Box<Simulation>,
    /// How it is drawn.
    #[cfg(feature = "scene-files")]
    pub(super) look: Option<super::sight::Look>,
}

impl core::fmt::Debug for AnyScene {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("AnyScene")
            .field("columns", &self.columns)
            .finish_non_exhaustive()
    }
}

/// The error for a name that is no column of a scene.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no column {name}; there are {}", names.join(", "))]
pub struct UnknownColumn {
    /// The unknown name.
    pub name: String,
    /// The names of the scene's columns.
    pub names: Vec<&'static str>,
}

/// What is found by the names of columns.
type Named<T> = core::result::Result<T, UnknownColumn>;

/// The place of the column with this name.
fn place(columns: &[Column], name: &str) -> Named<usize> {
    let found = columns.iter().position(|column| column.name == name);
    found.ok_or_else(|| UnknownColumn {
        name: name.to_owned(),
        names: columns.iter().map(|column| column.name).collect(),
    })
}

impl AnyScene {
    /// This scene, with its usual columns.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let table = AnyScene::scene(Box::new(ball)).simulate(&Request::at([2.0])?)?;
    /// assert_eq!(table.numbers(["velocity"]).unwrap(), [[1.5]]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn scene<S: Tabulated + Send + 'static>(scene: Box<dyn Scene<State = S>>) -> Self {
        let mut usual = S::columns();
        for (column, ..) in &mut usual.0 {
            column.usual = true;
        }
        let told = (0..usual.0.len()).collect();
        let columns = usual.and(scene.further());
        Self {
            columns: columns.0.iter().map(|(column, ..)| *column).collect(),
            told,
            simulation: Box::new(move |this, request| {
                let motion = scene.simulate(request)?;
                let rows = motion.rows.iter();
                let row = |(time, state): &(f64, S)| (*time, columns.row(&this.told, state));
                Ok(Table {
                    plan: motion.plan,
                    cost: motion.cost,
                    error_estimate: motion.error_estimate,
                    ledger: motion.ledger,
                    columns: this.told().collect(),
                    rows: rows.map(row).collect(),
                })
            }),
            #[cfg(feature = "scene-files")]
            look: None,
        }
    }

    /// The columns it can return, the usual ones first.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// assert!(scene.columns().iter().any(|column| column.name == "velocity" && column.unit == "m/s"));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The columns it returns, in the order of a row.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// assert!(scene.told().all(|column| column.usual));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn told(&self) -> impl Iterator<Item = Column> {
        self.told.iter().map(|&place| self.columns[place])
    }

    /// The scene with the columns of these names in place of the usual ones.
    ///
    /// # Errors
    /// [`UnknownColumn`] for the first name that is no column.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// let table = scene.telling(&["velocity"]).unwrap().simulate(&Request::at([2.0])?)?;
    /// assert_eq!(table.row(0), (2.0, vec![1.5]));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn telling<N: AsRef<str>>(mut self, names: &[N]) -> Named<Self> {
        let places = names.iter().map(|name| place(&self.columns, name.as_ref()));
        self.told = places.collect::<Named<_>>()?;
        Ok(self)
    }

    /// The picture of the scene at a row of a table with these columns. Only a scene from a file has one: `None` for
    /// any other.
    ///
    /// ```
    /// use spinning_bodies::scene::files::parse;
    /// let text = "[body]\nmoments = [1, 2, 3]\n[initial]\nomega = [0, 0, 2]\n[run]\ntimes = [1.0]\n";
    /// let (scene, request) = parse("mine.toml", text)?;
    /// let table = scene.simulate(&request).expect("a free top");
    /// let sight = scene.sight(&table.columns, &table.row(0).1).expect("a scene from a file");
    /// assert_eq!(sight.omega.norm(), 2.0);
    /// # Ok::<(), spinning_bodies::scene::files::Mistakes>(())
    /// ```
    #[cfg(feature = "scene-files")]
    pub fn sight(&self, columns: &[Column], row: &[f64]) -> Option<super::Sight> {
        let look = self.look.as_ref()?;
        Some(look(&super::sight::Told { columns, row }))
    }

    /// The motion at the requested times, as a table.
    ///
    /// # Errors
    /// As for [`Scene::simulate`].
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// let table = scene.simulate(&Request::at([0.0, 2.0])?)?;
    /// assert_eq!(table.rows().count(), 2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn simulate(&self, request: &Request) -> Result<Table> {
        (self.simulation)(self, request)
    }
}

/// A motion as a table of numbers.
#[derive(Debug)]
pub struct Table {
    /// The solver, and why.
    pub plan: Plan,
    /// The cost of the run.
    pub cost: Cost,
    /// Estimated error of the states, as in [`Motion::error_estimate`](super::Motion::error_estimate).
    pub error_estimate: f64,
    /// The conserved quantities and their drifts.
    pub ledger: Ledger,
    /// The columns of a row, after the time.
    pub columns: Vec<Column>,
    rows: Vec<(f64, Vec<f64>)>,
}

impl Table {
    /// The time (s) and the numbers of the row `place`, counted from 0.
    ///
    /// # Panics
    /// If there are not that many rows.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// let table = scene.simulate(&Request::at([0.0, 2.0])?)?;
    /// assert_eq!(table.row(1).0, 2.0);
    /// // Nothing is told as −0.
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, -0.0, -0.0)?;
    /// let still = AnyScene::scene(Box::new(ball)).simulate(&Request::at([1.0])?)?;
    /// assert!(still.row(0).1.iter().all(|number| number.is_sign_positive()));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn row(&self, place: usize) -> (f64, Vec<f64>) {
        self.rows[place].clone()
    }

    /// All rows, in the order of the requested times.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// let table = scene.simulate(&Request::at([0.0, 2.0])?)?;
    /// assert!(table.rows().map(|(time, _)| time).eq([0.0, 2.0]));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rows(&self) -> impl Iterator<Item = (f64, Vec<f64>)> {
        self.rows.iter().cloned()
    }

    /// The numbers in the columns of these names, `t` being the time, row by row.
    ///
    /// # Errors
    /// [`UnknownColumn`] for the first name that is no column of the table.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{AnyScene, Request, Roller}};
    /// let ball = Roller::new(RoundBody::new(0.17, 0.0286, 0.4)?, 9.81, 1.5, 0.0)?;
    /// let scene = AnyScene::scene(Box::new(ball));
    /// let table = scene.simulate(&Request::at([0.0, 2.0])?)?;
    /// assert_eq!(table.numbers(["t", "velocity"]).unwrap(), [[0.0, 1.5], [2.0, 1.5]]);
    /// assert!(table.numbers(["nothing"]).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn numbers<const N: usize>(&self, names: [&str; N]) -> Named<Vec<[f64; N]>> {
        let mut places = [None; N];
        for (column, name) in places.iter_mut().zip(names) {
            if name != "t" {
                *column = Some(place(&self.columns, name)?);
            }
        }
        let chosen = |(t, row): (f64, Vec<f64>)| places.map(|place| place.map_or(t, |p| row[p]));
        Ok(self.rows().map(chosen).collect())
    }
}
