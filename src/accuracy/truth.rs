//! stub
/// Row.
pub(super) type Row = [f64; 15];
pub(super) static FREE_TOP_1: [Row; 1] = [[1.0;15]];
pub(super) static FREE_TOP_10: [Row; 1] = [[1.0;15]];
pub(super) static FREE_TOP_1000: [Row; 1] = [[1.0;15]];
pub(super) static FREE_TOP_1000000: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SEPARATRIX_1: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SEPARATRIX_10: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SEPARATRIX_1000: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SEPARATRIX_1000000: [Row; 1] = [[1.0;15]];
pub(super) static CUSPED_TOP_1: [Row; 1] = [[1.0;15]];
pub(super) static CUSPED_TOP_10: [Row; 1] = [[1.0;15]];
pub(super) static CUSPED_TOP_1000: [Row; 1] = [[1.0;15]];
pub(super) static CUSPED_TOP_1000000: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SLEEPING_1: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SLEEPING_10: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SLEEPING_1000: [Row; 1] = [[1.0;15]];
pub(super) static NEAR_SLEEPING_1000000: [Row; 1] = [[1.0;15]];
pub(super) static KOVALEVSKAYA_1: [Row; 1] = [[1.0;15]];
pub(super) static KOVALEVSKAYA_10: [Row; 1] = [[1.0;15]];
pub(super) static KOVALEVSKAYA_1000: [Row; 1] = [[1.0;15]];
pub(super) static HEAVY_BODY_1: [Row; 1] = [[1.0;15]];
pub(super) static HEAVY_BODY_10: [Row; 1] = [[1.0;15]];
pub(super) static HEAVY_BODY_1000: [Row; 1] = [[1.0;15]];
pub(super) static TIPPE_TOP_1: [Row; 1] = [[1.0;15]];
pub(super) static TIPPE_TOP_10: [Row; 1] = [[1.0;15]];
pub(super) static TIPPE_TOP_100: [Row; 1] = [[1.0;15]];
