//! What each effect costs: every kind of scene with an effect and without it.
//!
//! The solver and the evaluations of the right-hand side are the same on every machine; `cargo bench -p lab --bench scenes -- --csv`
//! measures the time beside them, and the table it writes is the source of the figure and of the book's tables.

use super::Table;
use crate::Result;

/// A kind of scene, for the table of prices.
#[derive(Debug, Clone, Copy)]
pub struct Priced {
    /// The word after `kind`.
    pub kind: &'static str,
    /// The scene but for its effects.
    body: &'static str,
    /// What acts in any case while others are priced: places in `effects`.
    usual: &'static [usize],
    /// The effects: name, and the lines of the file that bring it about.
    pub effects: &'static [(&'static str, &'static str)],
}

/// All kinds that a scene file can name, each with all its effects.
pub const PRICED: &[Priced] = &[
    Priced {
        kind: "top",
        body: "[body]\nmass = 0.1\nmoments = [2.0e-4, 2.0e-4, 7.0e-5]\ncenter_of_mass = [0.0, 0.0, 0.04]\n\
               [initial]\nattitude = [0.9689124217106447, 0.24740395925452294, 0.0, 0.0]\nomega = [0.0, 0.0, 188.5]\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("pivot_friction", "pivot_friction = 1e-6"),
            ("bearing_friction", "bearing_friction = 1e-6"),
            ("air_drag", "air_drag = 1e-8"),
            ("tip_friction", "tip_friction = 1e-6"),
        ],
    },
    Priced {
        kind: "meteorite",
        body: "[body]\nmass = 1.0\nmoments = [0.4, 0.4, 0.4]\n[initial]\nvelocity = [0.0, 0.0, 0.0]\nomega = [0.0, 0.0, 1.0]\n",
        usual: &[],
        effects: &[(
            "impact",
            "impact_mass = 0.01\nimpact_velocity = [-10.0, -20.0, 5.0]\nimpact_at = [0.6, 0.0, 0.8]",
        )],
    },
    Priced {
        kind: "roller",
        body: "[body]\nmass = 0.17\nradius = 0.028575\ninertia_factor = 0.4\n[initial]\nvelocity = 2.0\nrim_speed = 0.0\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("friction", "friction = 0.2\nstatic_friction = 0.25"),
            ("rolling_resistance", "rolling_resistance = 0.01"),
            (
                "sheet",
                "sheet_friction = 0.3\nsheet_times = [0.0, 0.02]\nsheet_speeds = [0.0, 3.0]\nsheet_margin = 0.15",
            ),
        ],
    },
    Priced {
        kind: "spool",
        body: "[body]\nmass = 0.2\nradius = 0.05\ninertia_factor = 0.5\naxle = 0.02\n[initial]\nvelocity = 0.3\nrim_speed = 0.0\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("tug", "tension = 0.3\ntug_angle = 0.5235987755982988"),
            ("friction", "friction = 0.5\nstatic_friction = 0.6"),
            ("rolling_resistance", "rolling_resistance = 0.01"),
        ],
    },
    Priced {
        kind: "superball",
        body: "[body]\nmass = 0.05\ninertia_factor = 0.4\n[initial]\nheight = 0.3\nclimb = -5.0\nvelocity = 2.0\nrim_speed = 0.0\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("ceiling", "ceiling = 0.6"),
            (
                "restitution",
                "restitution = 0.9\ntangential_restitution = 0.8",
            ),
            ("grip", "grip = 0.5"),
        ],
    },
    Priced {
        kind: "yo-yo",
        body: "[body]\nmass = 0.055\nradius = 0.029\nlength = 1.0\naxle = 0.004\nwound = 0.010\n[initial]\nthrow = 0.5\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("turn_loss", "turn_loss = 0.9"),
            ("hand", "hand = 0.05"),
            ("sleep", "sleep = 0.2"),
            ("axle_friction", "axle_friction = 2.0e-4"),
            ("air_drag", "air_drag = 1.0e-8"),
        ],
    },
    Priced {
        kind: "strip",
        body: "[body]\nwidth = 0.02\nareal_density = 0.08\nfluid_density = 1.2\nthickness_ratio = 0.01\n\
               [initial]\nangle = 0.2\nvelocity = [0.0, 0.0]\nomega = 0.0\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("lift", "lift = [1.7, 1.1]"),
            ("drag", "drag = [1.7, 1.0]"),
            ("rotational_damping", "rotational_damping = [3.2263, 0.04]"),
            ("added_mass", "added_mass = 1.0"),
        ],
    },
    Priced {
        kind: "swivel",
        body: "[body]\nlower = 0.6\nupper = 2.0\n[initial]\nangular_momentum = 1.0\n",
        usual: &[],
        effects: &[
            (
                "four_phases",
                "four_phases = { arms_out = 2.0, arms_in = 0.7, twist = 1.5707963267948966, duration = 1.0, pace = \"even\" }",
            ),
            ("bearing_friction", "bearing_friction = 0.1"),
        ],
    },
    Priced {
        kind: "skater",
        body: "[body]\ncore = 0.8\nhand = 2.5\n[initial]\nreach = 0.7348469228349535\nspin = 12.566370614359172\n",
        usual: &[],
        effects: &[
            (
                "draw",
                "draw = { to = 0.2, begin = 0.2, duration = 0.6, pace = \"even\" }",
            ),
            ("bearing_friction", "bearing_friction = 0.1"),
        ],
    },
    Priced {
        kind: "cat",
        body: "[body]\nmass = [1.5, 1.5]\naxial = [0.0025, 0.0025]\ntransverse = [0.01, 0.01]\nto_joint = [0.11, 0.11]\n\
               [initial]\nattitude = [0.7071067811865476, 0.7071067811865476, 0.0, 0.0]\n",
        usual: &[],
        effects: &[
            (
                "turnover",
                "turnover = { forward = 1.0371873678400285, back = 1.0371873678400285, duration = 0.3, pace = \"even\" }",
            ),
            ("gravity", "gravity = 9.81"),
        ],
    },
    Priced {
        kind: "paper-cat",
        body: "[initial]\ntilt = 2.9670597283903604\n",
        usual: &[1],
        effects: &[("air", "air = 1.2"), ("gravity", "gravity = 9.81")],
    },
    Priced {
        kind: "crawler",
        body: "[body]\nmasses = [3.0, 1.0]\ngap = 0.3\nlength = 0.2\npush = 1.0\npull = 0.15\n",
        usual: &[],
        effects: &[(
            "ground_friction",
            "ground_friction = { coefficient = 0.1, gravity = 9.81 }",
        )],
    },
    Priced {
        kind: "table-top",
        body: "[body]\nmass = 0.02\nradius = 0.02\nsurface_center = [0.0, 0.0, 0.006]\n\
               inertia = [3.0e-6, 3.0e-6, 3.2e-6, 0.0, 0.0, 0.0]\n[initial]\ntilt = 0.1\naxial_spin = 155.0\n",
        usual: &[0],
        effects: &[
            ("gravity", "gravity = 9.81"),
            ("friction", "friction_law = \"viscous\"\nfriction = 0.3"),
            (
                "rolling_resistance",
                "rolling_resistance = 1e-4\npivoting_resistance = 1e-4",
            ),
        ],
    },
];

/// An effect that a kind of scene cannot do without: what lies on a table must be pressed to it.
pub const NEEDED: &[(&str, &str)] = &[("roller", "gravity"), ("spool", "gravity")];

impl Priced {
    /// The file with these effects, over one second, to 1e-9.
    pub fn file(&self, listed: impl Fn(usize) -> bool) -> String {
        let lines = self.effects.iter().enumerate();
        let lines: Vec<&str> = lines
            .filter(|(place, _)| listed(*place))
            .map(|(_, (_, lines))| *lines)
            .collect();
        format!(
            "kind = \"{}\"\n{}[effects]\n{}\n[run]\nuntil = 1.0\nsamples = 11\naccuracy = 1e-9\n",
            self.kind,
            self.body,
            lines.join("\n")
        )
    }

    /// The files without and with one effect, what is usual acting in both; without is nothing where the scene needs the effect.
    pub fn pair(&self, effect: usize) -> (Option<String>, String) {
        let needed = NEEDED.contains(&(self.kind, self.effects[effect].0));
        let usual = |place: usize| self.usual.contains(&place);
        let without = (!needed).then(|| self.file(|place| usual(place) && place != effect));
        (without, self.file(|place| usual(place) || place == effect))
    }
}

/// Runs the scene that a text describes.
///
/// # Errors
/// [`crate::Error`].
pub fn run(name: &str, text: &str) -> Result<Table> {
    let (scene, request) = super::parse(name, text)?;
    super::run(name, &scene, &request)
}
