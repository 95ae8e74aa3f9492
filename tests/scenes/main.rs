//! Scenes, kind by kind: every effect matters, its zero limit is its absence, and the ledger balances.

mod shape;
