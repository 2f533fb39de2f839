//! Work shared out among threads: those of rayon's pools with the feature `parallel`, the calling thread alone without it.
//! Both have the same functions, and no bit of a result depends on which of them runs.

#[cfg(feature = "parallel")]
mod pool;
#[cfg(not(feature = "parallel"))]
mod serial;

#[cfg(feature = "parallel")]
pub(crate) use pool::*;
#[cfg(not(feature = "parallel"))]
pub(crate) use serial::*;

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..1000).collect();
        let expected: Vec<u64> = items.iter().map(|x| x * x).collect();
        assert_eq!(map(&items, |i, x| i as u64 * x), expected);
        let mut results = vec![7; 3];
        map_into(&items, 16, |x| x * x, &mut results);
        assert_eq!(results, expected);
        assert_eq!(join(|| 1, || 2), (1, 2));
    }

    #[test]
    fn items_come_in_turn_until_one_breaks() {
        let items: Vec<usize> = (0..10_000).collect();
        let done = std::sync::Mutex::new(Vec::new());
        let until = |end: usize| {
            in_turn(&items, |i, x| {
                done.lock().expect("no panic").push(i + x);
                if i == end { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            let mut done = std::mem::take(&mut *done.lock().expect("no panic"));
            done.sort_unstable();
            done
        };
        assert_eq!(until(items.len()), items.iter().map(|x| 2 * x).collect::<Vec<_>>());
        let few = until(7);
        assert!(few.len() >= 8 && few.len() < 1000, "{} were begun", few.len());
        assert_eq!(few[..8], [0, 2, 4, 6, 8, 10, 12, 14]);
    }

    #[test]
    fn what_is_said_is_heard_in_order_before_the_result() {
        let mut heard = Vec::new();
        let result = listen_to(
            |say| {
                (0..100).for_each(|message| assert!(say(message).is_continue()));
                "done"
            },
            &mut |message| {
                heard.push(message);
                ControlFlow::Continue(())
            },
        );
        assert_eq!((result, heard), ("done", (0..100).collect::<Vec<i32>>()));
    }

    #[test]
    fn who_listens_can_break_it_off() {
        let mut heard = 0;
        // It would go on for ever.
        listen_to(|say| (0_u64..).take_while(|message| say(*message).is_continue()).count(), &mut |_| {
            heard += 1;
            ControlFlow::Break(())
        });
        assert!(heard >= 1);
    }

    #[cfg(feature = "parallel")]
    #[test]
    fn a_thread_of_a_pool_takes_no_others() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool");
        assert_eq!(pool.install(free_threads), 1);
    }
}
