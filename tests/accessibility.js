// Checks of a displayed page: names of controls, unique identifiers, contrast of texts, and the visible focus.

function isShown(element) {
  return element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
}

function nameOf(element) {
  const ids = (element.getAttribute("aria-labelledby") || "").split(/\s+/).filter(Boolean);
  const labels = [...ids.map(id => document.getElementById(id)), ...(element.labels ?? [])];
  const text = element.matches("button, a, summary, [role=button], [role=tab], [role=heading], pre") ? element.textContent : "";
  return [element.getAttribute("aria-label"), ...labels.map(label => label?.textContent), text, element.title]
    .map(name => (name ?? "").trim())
    .find(Boolean);
}

const ROLES_WITHOUT_NAME = new Set(["presentation", "none", "status", "alert", "tooltip", "log", "group", "main"]);

// Controls without a name.
function withoutName() {
  const controls = "button, a[href], input, select, textarea, summary, dialog[open], [role], [tabindex='0']";
  return [...document.querySelectorAll(controls)]
    .filter(element => isShown(element) && !element.closest("[aria-hidden=true]") && !ROLES_WITHOUT_NAME.has(element.role) && element.type !== "hidden")
    .filter(element => !nameOf(element))
    .map(element => element.outerHTML.slice(0, 150));
}

function doubleIds() {
  const ids = [...document.querySelectorAll("[id]")].map(element => element.id);
  return ids.filter((id, index) => ids.indexOf(id) !== index);
}

const pixel = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });

function rgba(colour) {
  pixel.clearRect(0, 0, 1, 1);
  pixel.fillStyle = colour;
  pixel.fillRect(0, 0, 1, 1);
  return [...pixel.getImageData(0, 0, 1, 1).data].map(value => value / 255);
}

function over(top, below) {
  return below.map((value, index) => top[index] * top[3] + value * (1 - top[3]));
}

function background(element) {
  const layers = [];
  for (let ancestor = element; ancestor; ancestor = ancestor.parentElement) {
    layers.push(rgba(getComputedStyle(ancestor).backgroundColor));
  }
  const canvas = matchMedia("(prefers-color-scheme: dark)").matches ? [0.07, 0.07, 0.07] : [1, 1, 1];
  return layers.reverse().reduce((below, top) => over(top, below), canvas);
}

// Relative luminance of WCAG 2.2.
function luminance(colour) {
  const [red, green, blue] = colour.map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

// Texts whose contrast is below that of WCAG 2.2, level AA.
function lowContrast() {
  const found = [];
  for (const element of document.querySelectorAll("body *")) {
    const hasText = [...element.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
    const isText = hasText || element.matches("input:not([type=range]), textarea, select");
    if (!isText || element.closest("svg, :disabled, [aria-disabled=true]") || !isShown(element)) {
      continue;
    }
    const style = getComputedStyle(element);
    const below = background(element);
    if (rgba(style.color)[3] === 0) {
      continue; // the arrow of a list beside its field
    }
    const [high, low] = [luminance(over(rgba(style.color), below)), luminance(below)].sort((a, b) => b - a);
    const ratio = (high + 0.05) / (low + 0.05);
    const size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (isLarge ? 3 : 4.5)) {
      found.push(`${ratio.toFixed(2)} ${element.tagName}.${element.className} ${element.textContent.slice(0, 40)}`);
    }
  }
  return found;
}

function isFocusVisible() {
  const element = document.activeElement;
  const style = getComputedStyle(element);
  const hasOutline = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0;
  return hasOutline || style.boxShadow !== "none" || (element.closest("svg") !== null && element.matches(":focus-visible"));
}

// Name of the element with the focus, and true if the focus is visible; null if it was reached before.
function nextStop() {
  const element = document.activeElement;
  window.stops ??= new Set();
  if (element === document.body || window.stops.has(element)) {
    return null;
  }
  window.stops.add(element);
  const { kind, port, part } = element.dataset;
  return [kind ?? port ?? part ?? element.getAttribute("name") ?? nameOf(element) ?? element.outerHTML, isFocusVisible()];
}
