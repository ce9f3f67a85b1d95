//! Work on all cores: pieces of it are taken by whichever thread is free, and what they give stands in their order, so that it
//! is the same for any number of threads. Knows nothing of what the work is.
//!
//! The one place that asks `rayon`: what depends on the kind of a result is a few lines here, and thousands of the compiler's in
//! its iterators.

mod forked;

use rayon::prelude::*;
use std::sync::Mutex;

/// How many pieces are worked on at the same time.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// What `of_piece` gives for each of `count` pieces, in their order.
pub fn map<T: Send>(count: usize, of_piece: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    let mut results: Vec<Mutex<Option<T>>> = Vec::new();
    results.resize_with(count, Mutex::default);
    for_each(count, &|piece| {
        let given = of_piece(piece);
        if let Ok(mut result) = results[piece].lock() {
            *result = Some(given);
        }
    });
    results.into_iter().filter_map(|result| result.into_inner().ok().flatten()).collect()
}

/// What `of_chunk` gives for each `size` items that follow one another, told the position of the first.
pub fn map_chunks<I: Sync, T: Send>(
    items: &[I],
    size: usize,
    of_chunk: &(dyn Fn(usize, &[I]) -> T + Sync),
) -> Vec<T> {
    map(items.len().div_ceil(size), &|chunk| {
        let first = chunk * size;
        of_chunk(first, &items[first..items.len().min(first + size)])
    })
}

/// Hands each `size` items that follow one another to `change`, told the position of the first.
pub fn for_each_chunk_mut<I: Send>(items: &mut [I], size: usize, change: &(dyn Fn(usize, &mut [I]) + Sync)) {
    let chunks: Vec<Mutex<&mut [I]>> = items.chunks_mut(size).map(Mutex::new).collect();
    for_each(chunks.len(), &|chunk| {
        if let Ok(mut items) = chunks[chunk].lock() {
            change(chunk * size, &mut items);
        }
    });
}

/// Hands each item to `change` with its position.
pub fn for_each_mut<I: Send>(items: &mut [I], change: &(dyn Fn(usize, &mut I) + Sync)) {
    let items: Vec<Mutex<&mut I>> = items.iter_mut().map(Mutex::new).collect();
    for_each(items.len(), &|at| {
        if let Ok(mut item) = items[at].lock() {
            change(at, &mut item);
        }
    });
}

/// Runs `work` on one of the threads, so that what it shares out begins there and does not wait for them each time.
pub fn within<T: Send>(work: &mut (dyn FnMut() -> T + Send)) -> T {
    let mut given = None;
    forked::on_own_threads(&mut || given = Some(rayon::scope(|_| work())));
    given.unwrap_or_else(work)
}

fn for_each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    forked::on_own_threads(&mut || (0..count).into_par_iter().for_each(work));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_the_pieces() {
        assert_eq!(map(1000, &|piece| piece * piece), (0..1000).map(|i| i * i).collect::<Vec<_>>());
        let items: Vec<u32> = (0..10).collect();
        let sums = map_chunks(&items, 4, &|first, some| (first, some.iter().sum::<u32>()));
        assert_eq!(sums, [(0, 6), (4, 22), (8, 17)]);
        let mut items = [0; 10];
        for_each_chunk_mut(&mut items, 3, &|first, some| some.iter_mut().for_each(|item| *item = first));
        assert_eq!(items, [0, 0, 0, 3, 3, 3, 6, 6, 6, 9]);
        for_each_mut(&mut items, &|at, item| *item += 10 * at);
        assert_eq!(items, [0, 10, 20, 33, 43, 53, 66, 76, 86, 99]);
        assert_eq!(within(&mut || map(3, &|piece| piece)), [0, 1, 2]);
    }
}
