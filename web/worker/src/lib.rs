//! A session in a worker of the browser: messages are bytes, as over a socket.

use js_sys::{Array, Uint8Array};
use origami_session::{Packet, Processor, Request, Session};
use wasm_bindgen::prelude::wasm_bindgen;

/// One sheet and the page that looks at it.
#[wasm_bindgen]
#[derive(Debug)]
pub struct WebSession(Session);

#[wasm_bindgen]
impl WebSession {
    /// One without a sheet.
    #[wasm_bindgen(constructor)]
    #[must_use]
    #[expect(clippy::new_without_default, reason = "JavaScript has constructors alone")]
    pub fn new() -> Self {
        Self(Session::new(Box::new(Processor)))
    }

    /// The replies to a request, each a `Uint8Array`.
    pub fn answer(&mut self, message: &[u8]) -> Array {
        let packet = Packet::from_bytes(message);
        let request = packet.and_then(|packet| packet.message::<Request>().map(|request| (request, packet.body)));
        let replies = match request {
            Ok((request, body)) => self.0.answer(request, &body),
            Err(malformed) => vec![Session::refusal(&malformed.to_string())],
        };
        replies.iter().map(|reply| Uint8Array::from(&reply.to_bytes()[..])).collect()
    }

    /// Whether the sheet moves, and does not wait to be seen.
    #[must_use]
    pub fn has_work(&self) -> bool {
        self.0.has_work()
    }

    /// Moves the sheet by so many steps at most.
    pub fn advance(&mut self, steps: u32) {
        self.0.advance(u64::from(steps));
    }

    /// The picture that was asked for, where there is a new one.
    pub fn take_frame(&mut self) -> Option<Vec<u8>> {
        self.0.take_frame().map(|frame| frame.to_bytes())
    }
}
