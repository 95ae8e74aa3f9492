//! The five Platonic solids (tutorial 2.6): vertices, faces, and their moments in closed form.

use crate::error::{Result, positive};

/// One of the five regular convex solids.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PlatonicSolid {
    /// Four triangles.
    Tetrahedron,
    /// Six squares.
    Cube,
    /// Eight triangles.
    Octahedron,
    /// Twelve pentagons.
    Dodecahedron,
    /// Twenty triangles.
    Icosahedron,
}

/// The golden ratio φ = (1+√5)/2.
const P: f64 = core::f64::consts::GOLDEN_RATIO;
/// φ² = φ + 1.
const Q: f64 = 2.618_033_988_749_895;

impl PlatonicSolid {
    /// All five, by number of faces.
    pub const ALL: [Self; 5] = [
        Self::Tetrahedron,
        Self::Cube,
        Self::Octahedron,
        Self::Dodecahedron,
        Self::Icosahedron,
    ];

    /// Moment of inertia about every axis through the centre, over mass times edge squared (2.6).
    ///
    /// 1/20, 1/6, 1/10, (95+39√5)/300, (3+√5)/20: correctly rounded constants.
    pub(crate) const fn inertia_factor(self) -> f64 {
        match self {
            Self::Tetrahedron => 1.0 / 20.0,
            Self::Cube => 1.0 / 6.0,
            Self::Octahedron => 1.0 / 10.0,
            Self::Dodecahedron => 0.607_355_503_741_639_3,
            Self::Icosahedron => 0.261_803_398_874_989_5,
        }
    }

    /// The faces, each a cycle of vertex numbers, counter-clockwise seen from outside.
    ///
    /// ```
    /// use spinning_bodies::inertia::PlatonicSolid;
    /// assert_eq!(PlatonicSolid::Dodecahedron.faces().len(), 12);
    /// assert!(PlatonicSolid::Dodecahedron.faces().iter().all(|face| face.len() == 5));
    /// ```
    pub fn faces(self) -> Vec<&'static [u32]> {
        let (corners, numbers): (usize, &[u32]) = match self {
            Self::Tetrahedron => (3, &TETRAHEDRON),
            Self::Cube => (4, &CUBE),
            Self::Octahedron => (3, &OCTAHEDRON),
            Self::Dodecahedron => (5, &DODECAHEDRON),
            Self::Icosahedron => (3, &ICOSAHEDRON),
        };
        numbers.chunks_exact(corners).collect()
    }

    /// The faces cut into triangles, as [`mesh_mass_properties`](super::mesh_mass_properties) wants them.
    ///
    /// ```
    /// use spinning_bodies::inertia::PlatonicSolid;
    /// assert_eq!(PlatonicSolid::Cube.triangles().len(), 12);
    /// ```
    pub fn triangles(self) -> Vec<[u32; 3]> {
        let fan = |face: &'static [u32]| {
            let others = face[1..].windows(2);
            others.map(|pair| [face[0], pair[0], pair[1]])
        };
        self.faces().into_iter().flat_map(fan).collect()
    }

    /// The vertices for a given edge length, m, centred at the origin; each coordinate to 1 ulp.
    ///
    /// # Errors
    /// [`NotPositive`](crate::Error::NotPositive) or [`NotFinite`](crate::Error::NotFinite) for the edge.
    ///
    /// ```
    /// use spinning_bodies::inertia::{PlatonicSolid, mesh_mass_properties};
    /// let solid = PlatonicSolid::Icosahedron;
    /// let body = mesh_mass_properties(&solid.vertices(1.0)?, &solid.triangles(), 1.0)?;
    /// let factor = body.inertia().matrix()[(0, 0)] / body.mass();
    /// assert!((factor - (3.0 + 5f64.sqrt()) / 20.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn vertices(self, edge: f64) -> Result<Vec<[f64; 3]>> {
        positive("the edge", edge)?;
        // Their edges are 2√2, 2, √2, 2 and 2 of these units.
        let (list, unit): (Vec<[f64; 3]>, f64) = match self {
            Self::Tetrahedron => {
                let every_other = [0, 3, 5, 6].map(|bits| signed(bits, [1.0; 3]));
                (every_other.into(), core::f64::consts::FRAC_1_SQRT_2 / 2.0)
            }
            Self::Cube => (cube(1.0).collect(), 0.5),
            Self::Octahedron => {
                let mut ends = [[0.0; 3]; 6];
                for (k, end) in ends.iter_mut().enumerate() {
                    end[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
                }
                (ends.into(), core::f64::consts::FRAC_1_SQRT_2)
            }
            Self::Dodecahedron => (cube(P).chain(rectangles(Q)).collect(), 0.5),
            Self::Icosahedron => (rectangles(P).collect(), 0.5),
        };
        let scaled = |vertex: [f64; 3]| vertex.map(|coordinate| coordinate * unit * edge);
        Ok(list.into_iter().map(scaled).collect())
    }
}

/// The vector with each component negated whose bit is set; the first component's bit is the highest of three.
fn signed(bits: usize, vector: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| match bits >> (2 - k) & 1 {
        0 => vector[k],
        _ => -vector[k],
    })
}

fn cube(half: f64) -> impl Iterator<Item = [f64; 3]> {
    (0..8).map(move |bits| signed(bits, [half; 3]))
}

/// The corners of three rectangles of half edges 1 and `long`, one across each axis.
fn rectangles(long: f64) -> impl Iterator<Item = [f64; 3]> {
    let three = [[0.0, 1.0, long], [1.0, long, 0.0], [long, 0.0, 1.0]];
    let signs = [[0, 1, 2, 3], [0, 2, 4, 6], [0, 1, 4, 5]];
    let corners = three.into_iter().zip(signs);
    corners.flat_map(|(corner, signs)| signs.map(|bits| signed(bits, corner)))
}

/// The corners of the faces, one face after another.
const TETRAHEDRON: [u32; 12] = [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2];
const CUBE: [u32; 24] = [
    0, 2, 3, 1, 0, 1, 5, 4, 0, 4, 6, 2, 1, 3, 7, 5, 2, 6, 7, 3, 4, 5, 7, 6,
];
const OCTAHEDRON: [u32; 24] = [
    0, 2, 4, 0, 5, 2, 0, 4, 3, 0, 3, 5, 1, 4, 2, 1, 2, 5, 1, 3, 4, 1, 5, 3,
];
const DODECAHEDRON: [u32; 60] = [
    0, 16, 17, 1, 12, 0, 8, 10, 2, 16, 0, 12, 14, 4, 8, 17, 3, 11, 9, 1, 9, 5, 14, 12, 1, 13, 3,
    17, 16, 2, 10, 6, 15, 13, 2, 3, 13, 15, 7, 11, 14, 5, 19, 18, 4, 18, 6, 10, 8, 4, 5, 9, 11, 7,
    19, 6, 18, 19, 7, 15,
];
const ICOSAHEDRON: [u32; 60] = [
    0, 2, 8, 10, 2, 0, 0, 4, 6, 0, 8, 4, 6, 10, 0, 9, 3, 1, 1, 3, 11, 1, 6, 4, 4, 9, 1, 1, 11, 6,
    2, 7, 5, 5, 8, 2, 2, 10, 7, 3, 5, 7, 3, 9, 5, 7, 11, 3, 4, 8, 9, 5, 9, 8, 6, 11, 10, 7, 10, 11,
];
