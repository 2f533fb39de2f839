// Pictures as one that moves: APNG with a palette, of each picture only what has changed.

import { crc32, deflateSync } from "node:zlib";

/** Colours of all pictures: those that are there most often, to five bits each; 255 is kept for what has not changed. */
function palette(frames) {
    const counts = new Map();
    for (const { data } of frames)
        for (let i = 0; i < data.length; i += 4) {
            const key = ((data[i] >> 3) << 10) | ((data[i + 1] >> 3) << 5) | (data[i + 2] >> 3);
            const known = counts.get(key) ?? [0, 0, 0, 0];
            known[0]++;
            for (let k = 0; k < 3; k++) known[k + 1] += data[i + k];
            counts.set(key, known);
        }
    const most = [...counts.values()].sort((a, b) => b[0] - a[0]).slice(0, 255);
    return most.map(([count, ...sums]) => sums.map((sum) => Math.round(sum / count)));
}

/** The number of the nearest colour, by what was asked before. */
function nearest(colours) {
    const known = new Map();
    return (r, g, b) => {
        const key = (r << 16) | (g << 8) | b;
        if (known.has(key)) return known.get(key);
        let [best, least] = [0, Infinity];
        colours.forEach(([x, y, z], i) => {
            const far = (x - r) ** 2 + (y - g) ** 2 + (z - b) ** 2;
            if (far < least) [best, least] = [i, far];
        });
        known.set(key, best);
        return best;
    };
}

const big = (...numbers) => Buffer.concat(numbers.map(([value, bytes]) => {
    const buffer = Buffer.alloc(bytes);
    buffer.writeUIntBE(value, 0, bytes);
    return buffer;
}));

function chunk(kind, data) {
    const named = Buffer.concat([Buffer.from(kind), data]);
    return Buffer.concat([big([data.length, 4]), named, big([crc32(named), 4])]);
}

/** `frames` are { width, height, data, milliseconds } of one size, with four bytes a pixel. */
export function apng(frames) {
    const { width, height } = frames[0];
    const colours = palette(frames);
    const index = nearest(colours);
    const chunks = [
        chunk("IHDR", big([width, 4], [height, 4], [8, 1], [3, 1], [0, 3])),
        chunk("acTL", big([frames.length, 4], [0, 4])),
        chunk("PLTE", Buffer.from([...colours.flat(), ...new Array(3 * (256 - colours.length)).fill(0)])),
        chunk("tRNS", Buffer.from([...new Array(255).fill(255), 0])),
    ];
    let before;
    let sequence = 0;
    for (const { data, milliseconds } of frames) {
        const now = new Uint8Array(width * height);
        for (let i = 0; i < now.length; i++) now[i] = index(data[4 * i], data[4 * i + 1], data[4 * i + 2]);
        let [x0, y0, x1, y1] = before ? [width, height, 0, 0] : [0, 0, width, height];
        if (before)
            for (let i = 0; i < now.length; i++)
                if (now[i] !== before[i]) {
                    const [x, y] = [i % width, Math.floor(i / width)];
                    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x + 1), Math.max(y1, y + 1)];
                }
        if (x1 <= x0) [x0, y0, x1, y1] = [0, 0, 1, 1];
        const rows = Buffer.alloc((x1 - x0 + 1) * (y1 - y0));
        let at = 0;
        for (let y = y0; y < y1; y++) {
            rows[at++] = 0;
            for (let x = x0; x < x1; x++) {
                const i = y * width + x;
                rows[at++] = before && now[i] === before[i] ? 255 : now[i];
            }
        }
        chunks.push(chunk("fcTL", big([sequence++, 4], [x1 - x0, 4], [y1 - y0, 4], [x0, 4], [y0, 4], [milliseconds, 2], [1000, 2], [0, 1], [before ? 1 : 0, 1])));
        const packed = deflateSync(rows, { level: 9 });
        chunks.push(before ? chunk("fdAT", Buffer.concat([big([sequence++, 4]), packed])) : chunk("IDAT", packed));
        before = now;
    }
    return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), ...chunks, chunk("IEND", Buffer.alloc(0))]);
}
