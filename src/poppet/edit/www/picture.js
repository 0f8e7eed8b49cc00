/* The drawing as a picture of its own, SVG or PNG, in light colours. */

const MARGIN = 2;  // grid units about the drawing
const SCALE = 20, MOST = 8000;  // pixels of a grid unit in a PNG file; largest width and height
const LEFT_OUT = "defs, title, desc, .grid, .reach, .area, .mark, .rubber, .band";
const CLEAR = "rgba(0, 0, 0, 0)";
const STATES = ["is-selected", "is-over", "is-possible", "is-impossible", "is-connecting", "is-start", "is-far"];
const STYLES = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "stroke-opacity", "opacity", "paint-order",
  "font-family", "font-size", "font-weight", "text-anchor", "dominant-baseline",
];

/* Return the drawing as the text of an SVG file, which needs no style sheet. */
export function pictureOf(title) {
  const drawing = document.getElementById("drawing");
  const holder = document.createElement("div");
  holder.className = "picture";
  for (const [name, value] of lightColours()) holder.style.setProperty(name, value);
  const copy = holder.appendChild(drawing.cloneNode(true));
  copy.removeAttribute("id");
  for (const element of [copy, ...copy.querySelectorAll("*")]) element.classList.remove(...STATES);
  for (const element of copy.querySelectorAll(LEFT_OUT)) element.remove();
  document.body.append(holder);
  try {
    const box = boxOf(copy);
    // All styles are read first: they depend on the classes of the elements around.
    const styled = [...copy.querySelectorAll("*")].map(element => [element, stylesOf(element)]);
    for (const [element, styles] of styled) freeze(element, styles);
    return serialised(copy, box, title);
  } finally {
    holder.remove();
  }
}

/* Return an SVG text as a PNG file. */
export async function pngOf(svg) {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const scale = Math.min(SCALE / 10, MOST / image.width, MOST / image.height);
    const canvas = Object.assign(document.createElement("canvas"), { width: Math.round(image.width * scale), height: Math.round(image.height * scale) });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise(resolve => canvas.toBlob(resolve, "image/png"));
  } finally {
    URL.revokeObjectURL(address);
  }
}

/* Let the browser write a file. */
export function download(name, blob) {
  const address = URL.createObjectURL(blob);
  const link = Object.assign(document.createElement("a"), { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/* Variables of the style sheets outside media queries: the light colours. */
function* lightColours() {
  for (const sheet of document.styleSheets) {
    for (const rule of sheet.cssRules) {
      if (rule.selectorText !== ":root") continue;
      for (const name of rule.style) if (name.startsWith("--")) yield [name, rule.style.getPropertyValue(name)];
    }
  }
}

/* Box of what is visible in a drawing, in grid units. */
function boxOf(svg) {
  const boxes = [...svg.children].filter(child => child.getBBox).map(child => child.getBBox()).filter(({ width, height }) => width || height);
  if (!boxes.length) return { x: 0, y: 0, width: 10, height: 10 };
  const [left, top] = ["x", "y"].map(name => Math.floor(Math.min(...boxes.map(box => box[name]))) - MARGIN);
  const right = Math.ceil(Math.max(...boxes.map(({ x, width }) => x + width))) + MARGIN;
  const bottom = Math.ceil(Math.max(...boxes.map(({ y, height }) => y + height))) + MARGIN;
  return { x: left, y: top, width: right - left, height: bottom - top };
}

function stylesOf(element) {
  const computed = getComputedStyle(element);
  const isHidden = computed.display === "none" || computed.visibility === "hidden";
  const isUnseen = element.tagName !== "g" && [computed.fill, computed.stroke].every(paint => paint === "none" || paint === CLEAR);
  if (isHidden || isUnseen || element.getAttribute("d") === "") return null;
  return STYLES.map(name => [name, computed.getPropertyValue(name)]).filter(([, value]) => value);
}

/* Replace classes by attributes, and remove what belongs to the page only. */
function freeze(element, styles) {
  if (styles === null) {
    element.remove();
    return;
  }
  const isGroup = element.tagName === "g";
  for (const { name } of [...element.attributes]) {
    if (/^(class|style|role|tabindex|id|aria-|data-)/.test(name)) element.removeAttribute(name);
  }
  // Attributes of groups are inherited, and each element has its own.
  if (isGroup) {
    const opacity = styles.find(([name]) => name === "opacity")[1];
    if (opacity !== "1") element.setAttribute("opacity", opacity);
    return;
  }
  for (const [name, value] of styles) if (!isDefault(name, value, element)) element.setAttribute(name, value);
}

function isDefault(name, value, element) {
  if (/^(font|text|dominant)/.test(name) && element.tagName !== "text") return true;
  if (name === "fill" || name === "stroke") return false;
  return ["1", "none", "normal", "butt", "miter", "auto", "start"].includes(value);
}

function serialised(svg, { x, y, width, height }, title) {
  const clean = svg.cloneNode(false);
  for (const { name } of [...clean.attributes]) if (name !== "xmlns") clean.removeAttribute(name);
  clean.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  clean.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
  clean.setAttribute("width", width * 10);
  clean.setAttribute("height", height * 10);
  const named = document.createElementNS("http://www.w3.org/2000/svg", "title");
  named.textContent = title || document.title;
  const paper = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of Object.entries({ x, y, width, height, fill: "#fff" })) paper.setAttribute(name, value);
  clean.append(named, paper, ...svg.children);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(clean)}\n`;
}
