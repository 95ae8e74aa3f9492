//! Long work: on all processors, and its progress on standard error, a bar on a terminal, elsewhere a line now and then.

use std::io::{IsTerminal, Write, stderr};
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use crate::writer::tell;

/// A run that ends before this shows nothing.
const PATIENCE: Duration = Duration::from_millis(1500);
/// Interval between updates of a bar.
const TICK: Duration = Duration::from_millis(100);

/// Does the work. If it takes longer than a moment, `how_far` gives the fraction done and a text: for a bar
/// ten times a second, otherwise for a line each time the elapsed time has doubled.
pub fn watched<T>(how_far: impl Fn() -> (f64, String) + Send, work: impl FnOnce() -> T) -> T {
    let (running, over) = channel::<()>();
    std::thread::scope(|scope| {
        scope.spawn(move || {
            let begin = Instant::now();
            let terminal = stderr().is_terminal();
            let mut wait = PATIENCE;
            while over.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                let (part, told) = how_far();
                if terminal {
                    let full = (part.clamp(0.0, 1.0) * PARTS as f64) as usize;
                    let (done, open) = ("█".repeat(full), "░".repeat(PARTS - full));
                    let _ = write!(stderr(), "{CLEARED}{done}{open} {told}");
                    wait = TICK;
                } else {
                    tell(told);
                    wait = begin.elapsed();
                }
            }
            if terminal && wait == TICK {
                let _ = write!(stderr(), "{CLEARED}");
            }
        });
        let result = work();
        drop(running);
        result
    })
}

/// Does work in this many parts and shows how many are done: `9 of 24 stills`. The work calls the function it is given after each part.
pub fn counted<T>(parts: usize, what: &str, work: impl FnOnce(&(dyn Fn() + Sync)) -> T) -> T {
    let done = AtomicUsize::new(0);
    let how_far = || {
        let done = done.load(Ordering::Relaxed);
        let told = format!("{done} of {parts} {what}");
        (done as f64 / parts as f64, told)
    };
    let count = || _ = done.fetch_add(1, Ordering::Relaxed);
    watched(how_far, || work(&count))
}

/// The parts of a work, in their order, done on all processors: each takes the next part as soon as it is free.
pub fn on_all_processors<T: Send>(parts: usize, part: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let taken = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&n| n < parts);
    let some = || Vec::from_iter(std::iter::from_fn(|| taken().map(|n| (n, part(n)))));
    let mut all = std::thread::scope(|scope| {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let threads = Vec::from_iter((0..processors).map(|_| scope.spawn(some)));
        let done = threads.into_iter().map(|thread| thread.join());
        done.flat_map(|done| done.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect::<Vec<_>>()
    });
    all.sort_by_key(|&(n, _)| n);
    all.into_iter().map(|(_, done)| done).collect()
}

/// Steps of a bar.
const PARTS: usize = 32;
/// To the beginning of the line, whose rest is erased.
const CLEARED: &str = "\r\x1b[K";
