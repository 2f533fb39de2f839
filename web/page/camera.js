// A camera that goes round the sheet. Matrices are columns after one another, as WebGL has them.

export const VIEWS = {
    corner: { turn: -0.7, tilt: 0.72 },
    top: { turn: 0, tilt: Math.PI / 2 },
    below: { turn: 0, tilt: -Math.PI / 2 },
    front: { turn: 0, tilt: 0 },
    side: { turn: Math.PI / 2, tilt: 0 },
};

const FIELD = 0.5;

export class Camera {
    constructor() {
        this.width = this.height = 1;
        this.look("corner");
    }

    /** To one of the views, and the whole sheet in sight. */
    look(name) {
        Object.assign(this, VIEWS[name], { centre: [0, 0, 0], zoom: 1 });
    }

    orbit(dx, dy) {
        this.turn -= dx * 0.008;
        this.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.tilt + dy * 0.008));
    }

    /** Moves the sheet by so many pixels. */
    pan(dx, dy) {
        const { right, up } = this.axes();
        const unit = this.pixel();
        for (let i = 0; i < 3; i++) this.centre[i] += (up[i] * dy - right[i] * dx) * unit;
    }

    /** By a factor, about a place on the screen. */
    zoomBy(factor, x = this.width / 2, y = this.height / 2) {
        const zoom = Math.max(0.1, Math.min(50, this.zoom * factor));
        const by = zoom / this.zoom - 1;
        this.pan((this.width / 2 - x) * by / (1 + by), (this.height / 2 - y) * by / (1 + by));
        this.zoom = zoom;
    }

    /** How long a pixel is at the centre. */
    pixel() {
        return 2 * this.distance() * Math.tan(FIELD / 2) / this.height;
    }

    distance() {
        const narrow = Math.min(1, this.width / this.height);
        return 1.03 / Math.sin(FIELD / 2) / narrow / this.zoom;
    }

    axes() {
        const [ct, st, ci, si] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
        return { right: [ct, st, 0], up: [-st * si, ct * si, ci], back: [st * ci, -ct * ci, si] };
    }

    /** From the sheet to the screen's cube. */
    matrix() {
        const { right, up, back } = this.axes();
        const d = this.distance();
        const eye = this.centre.map((c, i) => c + back[i] * d);
        const dot = (a) => -(a[0] * eye[0] + a[1] * eye[1] + a[2] * eye[2]);
        const f = 1 / Math.tan(FIELD / 2);
        const [near, far] = [Math.max(d - 6, d * 0.01), d + 6];
        const [a, b] = [(near + far) / (near - far), 2 * near * far / (near - far)];
        const fx = f * this.height / this.width;
        const m = new Float32Array(16);
        const rows = [[...right, dot(right)].map((x) => x * fx), [...up, dot(up)].map((x) => x * f)];
        const z = [...back, dot(back)];
        rows.push(z.map((x, i) => a * x + (i === 3 ? b : 0)), z.map((x) => -x));
        rows.forEach((row, r) => row.forEach((x, c) => (m[4 * c + r] = x)));
        return m;
    }

    /** Pixels and depth of a node. */
    project(m, points, node, to) {
        const [x, y, z] = [points[4 * node], points[4 * node + 1], points[4 * node + 2]];
        const w = m[3] * x + m[7] * y + m[11] * z + m[15];
        to[0] = (0.5 + 0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12]) / w) * this.width;
        to[1] = (0.5 - 0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * this.height;
        to[2] = w;
        return to;
    }

    /** A place moved by so many pixels across the line of sight. */
    moved([x, y, z], dx, dy) {
        const { right, up, back } = this.axes();
        const d = this.distance();
        const ahead = d - ([x, y, z].reduce((sum, p, i) => sum + (p - this.centre[i]) * back[i], 0));
        const unit = this.pixel() * ahead / d;
        return [x, y, z].map((p, i) => p + (right[i] * dx - up[i] * dy) * unit);
    }
}
