/* Colours of pressures, from blue (low) by ochre to red (high): also distinct for colour-blind readers, on light and dark. */

const LIGHT = [[38, 84, 148], [100, 120, 145], [170, 120, 20], [150, 25, 10]];
const DARK = [[120, 170, 240], [168, 180, 196], [226, 180, 70], [255, 128, 84]];

/* CSS colour of a share from 0 to 1. */
export function colourOf(share, isDark) {
  const stops = isDark ? DARK : LIGHT, at = Math.max(0, Math.min(1, share)) * (stops.length - 1);
  const k = Math.min(stops.length - 2, Math.floor(at)), part = at - k;
  const mixed = stops[k].map((value, j) => Math.round(value + (stops[k + 1][j] - value) * part));
  return `rgb(${mixed.join(" ")})`;
}
