// Colours: of edges by letter, of paper, and of maps. Style sheets have them as variables, so that light and dark differ there.

/** Viridis (van der Walt and Smith, 2015) at nine places: even to the eye, and readable without colour. */
const VIRIDIS = [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725];

export const MAPS = {
    none: { name: "Paper", unit: "" },
    strain: { name: "Strain", unit: " %", factor: 100 },
    "angle-error": { name: "Angle error", unit: "°", factor: 1 },
    energy: { name: "Energy", unit: "", factor: 1 },
};

/** Colours of the theme at a place of the page, each three numbers from 0 to 1. */
export function theme(place = document.documentElement) {
    const style = getComputedStyle(place);
    const colour = (name) => rgb(style.getPropertyValue(`--${name}`).trim());
    const names = ["front", "back", "ground", "line-b", "line-m", "line-v", "line-f", "line-u", "accent", "warn", "pin"];
    return Object.fromEntries(names.map((name) => [name, colour(name)]));
}

/** The nine colours of the map, for a shader. */
export const ramp = () => new Float32Array(VIRIDIS.flatMap((hex) => rgb(`#${hex.toString(16).padStart(6, "0")}`)));

/** The map as a background of a bar. */
export const gradient = () => `linear-gradient(to right, ${VIRIDIS.map((hex) => `#${hex.toString(16).padStart(6, "0")}`).join(", ")})`;

export const css = ([r, g, b], alpha = 1) => `rgb(${255 * r} ${255 * g} ${255 * b} / ${alpha})`;

/** Which of the theme's lines a letter has. */
export const lineOf = (letter) => ({ B: "line-b", M: "line-m", V: "line-v", F: "line-f", J: "line-f" })[letter] ?? "line-u";

function rgb(hex) {
    const value = parseInt(hex.slice(1), 16);
    return [16, 8, 0].map((shift) => ((value >> shift) & 255) / 255);
}
