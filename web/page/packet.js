// How messages travel: the length of a head, the head as JSON padded to four bytes, and a body. crates/origami-session says the same.

const coder = new TextEncoder();
const decoder = new TextDecoder();

/** A request with a body as bytes; one without is its JSON. */
export function packed(request, body) {
    const head = coder.encode(JSON.stringify(request));
    const length = 4 * Math.ceil(head.length / 4);
    const bytes = new Uint8Array(4 + length + body.length).fill(32);
    new DataView(bytes.buffer).setUint32(0, length, true);
    bytes.set(head, 4);
    bytes.set(body, 4 + length);
    return bytes;
}

/** The head of a reply, and where in the buffer its body begins. */
export function unpacked(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    return { head: JSON.parse(decoder.decode(new Uint8Array(buffer, 4, length))), buffer, at: 4 + length };
}
