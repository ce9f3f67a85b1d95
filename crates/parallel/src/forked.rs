//! Threads of this process alone. A process that was forked off another (Python's `multiprocessing` does so on Linux) has that one's
//! memory and none of its threads: what is shared out to them would wait for ever.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// The process that began rayon's own threads; 0 before any did.
static FIRST: AtomicU32 = AtomicU32::new(0);
/// The threads of a forked process, and which that is.
static OWN: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Runs `work`, which shares out what it does, where that goes to threads of this process.
pub(super) fn on_own_threads(work: &mut (dyn FnMut() + Send)) {
    let this = process::id();
    let first = match FIRST.compare_exchange(0, this, Ordering::Relaxed, Ordering::Relaxed) {
        Ok(_) => this,
        Err(first) => first,
    };
    if first == this {
        return work();
    }
    match own_threads(this) {
        Some(threads) => threads.install(work),
        None => work(),
    }
}

/// The threads of the forked process `this`; `None` where there can be none.
fn own_threads(this: u32) -> Option<Arc<ThreadPool>> {
    let mut own = OWN.lock().unwrap_or_else(PoisonError::into_inner);
    match &*own {
        Some((of, threads)) if *of == this => return Some(threads.clone()),
        _ => {}
    }
    // Where the system gives no threads, this one is all there is.
    let alone = || ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    let threads = Arc::new(ThreadPoolBuilder::new().build().or_else(|_| alone()).ok()?);
    // Those of a process between are as lost as the first one's: nobody may wait for their end.
    std::mem::forget(own.replace((this, threads.clone())));
    Some(threads)
}
