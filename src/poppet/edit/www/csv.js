/* Tables of measured values: CSV with a header, separated by comma, semicolon or tab. */

/* Return the columns {name, unit, values} of a text, or throw an Error with the key of a message. */
export function readTable(content) {
  const lines = content.replace(/^\ufeff/, "").split(/\r?\n/).filter(line => line.trim() && !line.startsWith("#"));
  if (/[\0-\x08\x0e-\x1f\ufffd]/.test(content)) throw new Error("measured.binary");
  if (lines.length < 3) throw new Error("measured.rows");
  const sign = ["\t", ";", ","].reduce((a, b) => (lines[0].split(b).length > lines[0].split(a).length ? b : a));
  const heads = cells(lines[0], sign).map(nameAndUnit);
  const rows = lines.slice(1).map(line => cells(line, sign).map(cell => numberOf(cell, sign)));
  return heads.map((head, k) => ({ ...head, values: Float64Array.from(rows, row => row[k] ?? NaN) }));
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

/* A comma is a decimal comma, unless it separates the cells. */
function numberOf(cell, sign) { return cell === "" ? NaN : Number(sign === "," ? cell : cell.replace(",", ".")); }
