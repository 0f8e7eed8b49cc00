/* Tables of measured values: CSV with a header, separated by comma, semicolon or tab. */

// Spellings of numbers, cells without a value and points between thousands, as in timeseries/tables/text.py.
const NUMBER = {
  ".": /^(?:[+-]?(?:\d+\.?\d*|\.\d+)(?:[ed][+-]?\d+)?|[+-]?inf(?:inity)?)$/i,
  ",": /^(?:[+-]?(?:\d+(?:,\d+)?|,\d+)(?:[ed][+-]?\d+)?|[+-]?inf(?:inity)?)$/i,
};
const EMPTY = /^(?:|nan|na|n\/a|null|none|-{1,3})$/i;
const THOUSANDS = /^[+-]?[1-9]\d{0,2}\.\d{3}$/, BELOW_THOUSAND = /^[+-]?\d{1,3}$/;
const JUMP = 100;  // between neighbouring values, if points separate thousands

/* Return the columns {name, unit, values} of a text, or throw an Error with the key of a message, and its `facts`. */
export function readTable(content) {
  const lines = content.replace(/^\ufeff/, "").split(/\r?\n/).filter(line => line.trim() && !line.startsWith("#"));
  if (/[\0-\x08\x0e-\x1f\ufffd]/.test(content)) throw new Error("measured.binary");
  if (lines.length < 3) throw new Error("measured.rows");
  const sign = ["\t", ";", ","].reduce((a, b) => (lines[0].split(b).length > lines[0].split(a).length ? b : a));
  const heads = cells(lines[0], sign).map(nameAndUnit);
  const rows = lines.slice(1).map(line => cells(line, sign));
  const decimal = decimalOf(rows);
  return heads.map((head, k) => ({ ...head, values: valuesOf(head.name, rows.map(row => row[k] ?? ""), decimal) }));
}

/* Cells of a line; a quoted cell can contain the separator. */
function cells(line, sign) {
  const found = [];
  let cell = "", isQuoted = false;
  for (let k = 0; k < line.length; k++) {
    const character = line[k];
    if (character === '"' && isQuoted && line[k + 1] === '"') cell += line[++k];
    else if (character === '"') isQuoted = !isQuoted;
    else if (character === sign && !isQuoted) {
      found.push(cell);
      cell = "";
    } else cell += character;
  }
  // An apostrophe protects names that a spreadsheet takes for a formula.
  return [...found, cell].map(value => value.trim().replace(/^'(?='*[=+\-@\t\r])/, ""));
}

/* "tank.pressure [bar]" or "pressure (bar)". */
function nameAndUnit(head) {
  const match = /^(.*?)\s*[[(]([^\])]*(?:\([^)]*\))?[^\])]*)[\])]\s*$/.exec(head);
  return match ? { name: match[1], unit: match[2].trim() } : { name: head, unit: "" };
}

/* Decimal sign with which more cells are numbers; a comma in a cell of a file with commas was in quotes. */
function decimalOf(rows) {
  const [points, commas] = [".", ","].map(sign => rows.reduce((sum, row) => sum + row.filter(cell => NUMBER[sign].test(cell)).length, 0));
  return commas > points ? "," : ".";
}

/* Values of a column; NaN in empty cells, and in all cells if less than half of them are numbers. */
function valuesOf(column, texts, decimal) {
  const isInvalid = cell => !NUMBER[decimal].test(cell) && !EMPTY.test(cell);
  const invalid = texts.filter(isInvalid);
  if (invalid.length > 0.5 * texts.length) return new Float64Array(texts.length).fill(NaN);
  if (invalid.length) throw problemWith("measured.cell", { cell: invalid[0], column });
  const values = Float64Array.from(texts, cell => (EMPTY.test(cell) ? NaN : numberOf(cell)));
  if (decimal === ".") rejectThousands(column, texts, values);
  return values;
}

function numberOf(cell) {
  return /inf/i.test(cell) ? (cell.startsWith("-") ? -Infinity : Infinity) : Number(cell.replace(",", ".").replace(/d/i, "e"));
}

/* Throw an error if a value such as 1.013 is beside 993, and all others have one of these two forms. */
function rejectThousands(column, texts, values) {
  if (!texts.every(cell => THOUSANDS.test(cell) || BELOW_THOUSAND.test(cell) || EMPTY.test(cell))) return;
  for (let k = 1; k < texts.length; k++) {
    const [before, after] = [texts[k - 1], texts[k]], sizes = [values[k - 1], values[k]].map(Math.abs);
    const isJump = Math.min(...sizes) > 0 && Math.max(...sizes) > JUMP * Math.min(...sizes);
    if (isJump && THOUSANDS.test(before) !== THOUSANDS.test(after)) throw problemWith("measured.thousands", { column, before, after });
  }
}

function problemWith(key, facts) { return Object.assign(new Error(key), { facts }); }
