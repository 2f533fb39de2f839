//! A session in a worker of the browser: messages are bytes, as over a socket.
//!
//! Numbers go in and out, and bytes lie in the module's memory, at places that the functions tell; so that nothing has to be
//! generated for JavaScript, which `worker.js` shows.

use std::cell::RefCell;
use std::collections::VecDeque;

use origami_session::{Packet, Processor, Request, Session};

/// One sheet, and what was said about it.
struct Worker {
    session: Session,
    /// What the page says.
    message: Vec<u8>,
    /// What it is told, in order.
    replies: VecDeque<Packet>,
    /// What it reads now.
    reply: Vec<u8>,
}

thread_local! {
    static WORKER: RefCell<Worker> = RefCell::new(Worker {
        session: Session::new(Box::new(Processor)),
        message: Vec::new(),
        replies: VecDeque::new(),
        reply: Vec::new(),
    });
}

fn with<T>(does: impl FnOnce(&mut Worker) -> T) -> T {
    WORKER.with_borrow_mut(does)
}

// The names are what JavaScript calls; nothing else in the module has them.

/// Where a message of so many bytes is to be written, before [`origami_answer`] is called.
#[unsafe(no_mangle)]
pub extern "C" fn origami_message(bytes: usize) -> *mut u8 {
    with(|worker| {
        worker.message.clear();
        worker.message.resize(bytes, 0);
        worker.message.as_mut_ptr()
    })
}

/// Answers the message; what there is to be told comes by [`origami_next`].
#[unsafe(no_mangle)]
pub extern "C" fn origami_answer() {
    with(|worker| {
        let packet = Packet::from_bytes(&worker.message);
        let request = packet.and_then(|packet| packet.message::<Request>().map(|request| (request, packet.body)));
        match request {
            Ok((request, body)) => worker.replies.extend(worker.session.answer(request, &body)),
            Err(malformed) => worker.replies.push_back(Session::refusal(&malformed.to_string())),
        }
    });
}

/// Whether the sheet moves, and does not wait to be seen.
#[unsafe(no_mangle)]
pub extern "C" fn origami_has_work() -> bool {
    with(|worker| worker.session.has_work())
}

/// Moves the sheet by so many steps at most.
#[unsafe(no_mangle)]
pub extern "C" fn origami_advance(steps: u32) {
    with(|worker| worker.session.advance(u64::from(steps)));
}

/// How many bytes the next reply has, the picture that was asked for among them once there is a new one; 0 where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn origami_next() -> usize {
    with(|worker| {
        let next = worker.replies.pop_front().or_else(|| worker.session.take_frame());
        worker.reply = next.map(|packet| packet.to_bytes()).unwrap_or_default();
        worker.reply.len()
    })
}

/// Where that reply lies, until the next is asked for.
#[unsafe(no_mangle)]
pub extern "C" fn origami_reply() -> *const u8 {
    with(|worker| worker.reply.as_ptr())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The replies to a message that was written where it should be.
    fn told(message: &[u8]) -> Vec<String> {
        let place = origami_message(message.len());
        with(|worker| {
            assert_eq!(place, worker.message.as_mut_ptr());
            worker.message.copy_from_slice(message);
        });
        origami_answer();
        let heads = std::iter::from_fn(|| (origami_next() > 0).then(|| with(|worker| worker.reply.clone())));
        heads.map(|bytes| Packet::from_bytes(&bytes).expect("a packet").head).collect()
    }

    #[test]
    fn a_message_is_answered_and_a_broken_one_refused() {
        let request = |json: &str| Packet { head: json.to_owned(), body: Vec::new() }.to_bytes();
        let opened = told(&request(r#"{"do":"generate","name":"miura"}"#));
        assert!(opened.len() == 1 && opened[0].contains(r#""is":"opened""#), "{opened:?}");
        assert!(told(&request(r#"{"do":"fold","percent":50}"#)).is_empty() && origami_has_work());
        assert!(told(&request(r#"{"do":"frame"}"#)).is_empty(), "it has not moved yet");
        origami_advance(1);
        assert!(origami_next() > 0 && origami_next() == 0);
        assert!(told(&[1, 2, 3])[0].contains("error") && told(&request("{}"))[0].contains("error"));
    }
}
