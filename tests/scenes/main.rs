//! Scenes: every effect changes the answer, its zero limit does not, the ledger balances, and closed forms agree with integrators.

mod contact;
