/* The page around the kernel: sliders, curves, drawing, variants, measured values. Names of a circuit go into the page
   as text only. */
(async () => {
  const { header, blobs } = await unpacked(document.getElementById("model").textContent);
  const target = connectionOf(location.hash);
  if (target) { new ConnectedPage(header, target); return; }
  const kernel = await Kernel.of({ header, blobs });
  const find = id => document.getElementById(id), { outputs, sliders } = header;
  const make = (tag, kind, parent, text) => {
    const found = document.createElement(tag);
    if (kind) found.className = kind;
    if (text !== undefined) found.textContent = text;
    return parent ? parent.appendChild(found) : found;
  };
  const [timeName, timeSize] = header.time, figure = find("curves"), plot = figure.plot;
  const MOST_POINTS = 200;  // of a course
  const digits = fiveDigits;
  const time = Float64Array.from(kernel.grid, t => t / timeSize), end = time[time.length - 1];
  for (const panel of plot.panels) for (const line of panel.spec.lines ?? []) line.x = time;
  const state = { changed: new Map(), kept: null, at: null, measured: [], runs: {} };
  const byAddress = new Map(sliders.map(s => [s.address, s]));

  /* --- Runs --- */

  /* Changed values for the kernel: a number, or the course of an input. */
  function given(changed) {
    const values = [...kernel.map.values], inputs = [];
    for (const [address, value] of changed) {
      const slider = byAddress.get(address), isHeld = typeof value === "number";
      if (slider.number >= 0 && isHeld) values[slider.number] = value;
      if (slider.number < 0 || slider.is_driven || !isHeld) for (const input of slider.inputs) inputs.push(isHeld ? [input, [[0, value, 0, false]]] : [input, segments(value), slider.delay]);
    }
    return kernel.changes(values, inputs);
  }

  /* Time, value, slope and jump of each segment of a course. */
  function segments({ kind, times, values }) {
    const isSteps = kind === "steps";
    const rows = times.map((t, k) => [t, values[k], isSteps || k + 1 === times.length ? 0 : (values[k + 1] - values[k]) / (times[k + 1] - t),
                                      isSteps && k > 0 && values[k] !== values[k - 1]]);
    if (times[0] > 0) rows.unshift([0, values[0], 0, false]);
    return rows;
  }

  function run(changed) {
    const ended = kernel.run(...given(changed)), { rows } = ended;
    const last = ended.status === "stopped" ? ended.reached / timeSize : null;
    return { ended, rows, last, table: kernel.table };
  }

  /* An output in its display unit. */
  function shown(table, k) {
    const { factor, shift } = outputs[k], n = time.length, found = new Float64Array(n);
    for (let j = 0; j < n; j++) found[j] = table[k * n + j] * factor + shift;
    return found;
  }

  /* --- Curves and bars --- */

  const lineOf = (panel, output) => panel.spec.lines?.find(line => (line.cells ?? [line.output]).includes(output));

  function draw(table, isKept) {
    for (const panel of plot.panels) for (const line of panel.spec.lines ?? []) if ("output" in line && !!line.isKept === isKept) {
      if (line.cells) [line.y, line.high] = table ? edgesOf(line.cells.map(k => shown(table, k))) : [[], []];
      else line.y = table ? shown(table, line.output) : [];
    }
  }

  function bars() {
    const panel = plot.panels.find(one => one.spec.rows);
    if (!panel) return;
    const runs = [["", state.runs.now], ...state.kept ? [[" (A)", state.runs.kept]] : []];
    const rows = [], boxes = new Map(panel.spec.boxes.map(box => [box.label, box]));
    for (const box of boxes.values()) box.at = [];
    for (const band of header.bands) for (const [mark, { table, rows: reached }] of runs) {
      spans(band, table, reached, rows.length, boxes);
      rows.push([rows.length, band.label + mark]);
    }
    const isOther = rows.length !== panel.spec.rows.length;
    panel.spec.rows = rows;
    for (const [label, box] of boxes) panel.buttons.get(label).hidden = !box.at.length;
    if (!isOther) return;
    panel.spec.y.range = [rows.length - .5, -.5];
    panel.view.y = [...panel.spec.y.range];
    panel.resize();
    panel.scale();
  }

  function spans({ output, looks, flow, still }, table, reached, row, boxes) {
    const n = time.length, codes = table.subarray(output * n, output * n + reached);
    const flows = flow < 0 ? null : table.subarray(flow * n, flow * n + reached);
    let least = 0;
    if (flows) { for (const v of flows) least = Math.max(least, Math.abs(v)); least = still * Math.max(least, 1e-3); }
    const code = k => flows && Math.abs(flows[k]) <= least && Math.abs(codes[k]) <= 1 ? 0 : codes[k];
    const names = new Map(looks.map(([value, text]) => [value, text]));
    for (let k = 0; k < reached - 1;) {
      const own = code(k), from = k;
      while (k < reached - 1 && code(k) === own) k++;
      boxes.get(names.get(own))?.at.push(time[from], row - .36, time[k], row + .36);
    }
  }

  function scaled(panel) {
    if (!panel.spec.rows) {
      const range = panel.heights(panel.spec.x.range);
      if (range) panel.spec.y.range = range;
    }
    if (panel.isWhole) panel.reset();
    else panel.u.redraw(false);
    panel.read();
  }

  /* An invisible panel is drawn when it becomes visible or is printed. */
  const away = new Set();
  for (const panel of plot.panels) new IntersectionObserver(seen => {
    if (!seen[seen.length - 1].isIntersecting) away.add(panel);
    else if (away.delete(panel)) scaled(panel);
  }, { rootMargin: "100px" }).observe(panel.box);
  addEventListener("beforeprint", () => away.forEach(scaled));

  /* --- Schematic: values and moving bodies at the time of the pointer --- */

  const drawing = new PageDrawing(find("drawing"), header.drawing, outputs);
  // Enlarged texts of 7.5 units have at least 12 pixels. The frame then shows the first moving body; a telephone begins so.
  drawing.svg.style.setProperty("--readable", `${1.6 * drawing.svg.viewBox.baseVal.width}px`);
  function enlarged(isLarge) {
    const frame = find("drawing"), [centre] = [...header.drawing.movers, ...header.drawing.values];
    frame.classList.toggle("is-large", isLarge);
    find("size").textContent = isLarge ? "Whole" : "Enlarge";
    find("size").setAttribute("aria-label", isLarge ? "Whole drawing" : "Enlarge the drawing");
    if (!isLarge || !centre) return;
    const scale = drawing.svg.clientWidth / drawing.svg.viewBox.baseVal.width;
    frame.scrollTo(centre.x * scale - frame.clientWidth / 2, centre.y * scale - frame.clientHeight / 2);
  }
  enlarged(matchMedia("(max-width: 40rem)").matches);
  find("size").onclick = () => enlarged(!find("drawing").classList.contains("is-large"));

  function along(k, at) {
    const n = time.length, { table, rows } = state.runs.now, offset = k * n;
    let a = 0, b = Math.max(rows - 1, 0);
    if (at >= time[b]) return table[offset + b];
    while (b - a > 1) { const m = (a + b) >> 1; if (time[m] <= at) a = m; else b = m; }
    return table[offset + a] + (table[offset + b] - table[offset + a]) * (at - time[a]) / (time[b] - time[a]);
  }

  function live() {
    const at = state.at ?? end, { table, rows } = state.runs.now, n = time.length;
    drawing.show(k => along(k, at), k => {
      let [low, high] = [Infinity, -Infinity];
      for (const v of table.subarray(k * n, k * n + rows)) { low = Math.min(low, v); high = Math.max(high, v); }
      return [low, high];
    });
    find("time").value = at;
    find("clock").textContent = `${digits(at)} ${timeName}`;
  }

  const clock = find("time");
  Object.assign(clock, { min: 0, max: end, step: end / 1000 });
  clock.oninput = () => { state.at = +clock.value; live(); };
  for (const panel of plot.panels) panel.u.over.addEventListener("pointermove", () => {
    const { left } = panel.u.cursor;
    if (left >= 0) { state.at = Math.min(end, Math.max(0, panel.u.posToVal(left, "x"))); live(); }
  });
  let playing = 0;
  find("play").onclick = () => {
    const button = find("play");
    if (playing) { cancelAnimationFrame(playing); playing = 0; button.textContent = "Play"; return; }
    button.textContent = "Pause";
    const began = performance.now(), from = state.at !== null && state.at < end ? state.at : 0;
    const frame = now => {
      state.at = from + (now - began) / 8000 * end;
      if (state.at >= end) { state.at = end; playing = 0; button.textContent = "Play"; live(); return; }
      live();
      playing = requestAnimationFrame(frame);
    };
    playing = requestAnimationFrame(frame);
  };

  /* --- Sliders --- */

  const marked = (field, isBad) => isBad ? field.setAttribute("aria-invalid", "true") : field.removeAttribute("aria-invalid");
  const numberIn = field => { const text = field.value.trim().replace(",", "."); return text === "" ? NaN : Number(text); };

  /* Text of the error of a field; screen readers announce it. */
  function explained(id, parent, ...fields) {
    const node = make("span", "why", parent);
    Object.assign(node, { id, role: "status" });
    node.setAttribute("aria-live", "polite");
    for (const field of fields) field.setAttribute("aria-describedby", id);
    return text => { if (node.textContent !== text) node.textContent = text; };
  }

  /* Limits of a quantity in its display unit, as text. */
  function limitsOf({ least, most, above, below, factor, shift, shown: unit }) {
    const text = v => `${digits(v * factor + shift)}${unit ? ` ${unit}` : ""}`, isOpen = v => Math.abs(v) >= 1e300;
    const low = isOpen(least) ? "" : above === null ? `at least ${text(least)}` : `above ${text(above)}`;
    const high = isOpen(most) ? "" : below === null ? `at most ${text(most)}` : `below ${text(below)}`;
    return [low, high].filter(Boolean).join(" and ");
  }
  function problemOf(slider, value) {
    const limits = limitsOf(slider), unit = slider.shown ? ` in ${slider.shown}` : "";
    if (Number.isFinite(value) && value >= slider.least && value <= slider.most) return "";
    return `${Number.isFinite(value) ? "Outside the limits" : "Not a number"}: enter a number${unit}${limits ? `, ${limits}` : ""}.`;
  }
  const rows = sliders.map(slider => {
    const row = make("div", "row", find("sliders")), { factor, shift, shown: unit } = slider;
    const label = make("label", "", row), out = v => v * factor + shift, back = v => (v - shift) / factor;
    const field = make("input", "", row), range = make("input", "", row), reset = make("button", "", row, "↺");
    for (const word of slider.address.split(/(?<=[._])/)) { label.append(word); make("wbr", "", label); }
    if (slider.is_assumed) make("abbr", "assumed", label, " *").title = "assumed";
    label.title = `${slider.meaning}\n${slider.source}`;
    field.id = label.htmlFor = `n-${slider.address}`;
    make("span", "unit", row, unit);
    const course = slider.course && courseOf(slider, row);
    const kept = make("span", "kept", row);
    const ends = [out(slider.low), out(slider.high)];
    Object.assign(range, { type: "range", min: ends[0], max: ends[1], step: "any" });
    Object.assign(field, { type: "text", inputMode: "decimal", autocomplete: "off" });
    range.setAttribute("aria-label", slider.address);
    Object.assign(reset, { type: "button", title: "As in the file" });
    reset.setAttribute("aria-label", `${slider.address} as in the file`);
    const show = () => {
      const value = state.changed.get(slider.address), isCourse = typeof value === "object";
      const own = out(isCourse ? value.values[0] : value ?? slider.value);
      range.value = own;
      if (document.activeElement !== field) field.value = isCourse || value === undefined && slider.is_driven ? "" : digits(own);
      field.placeholder = isCourse ? "course" : slider.is_driven ? "signal" : "";
      course?.(value);
      if (document.activeElement !== field || problemOf(slider, back(numberIn(field))) === "") { marked(field, false); explain(""); }
      reset.disabled = value === undefined;
      row.classList.toggle("is-changed", value !== undefined);
      const usual = slider.is_driven ? "signal" : slider.value, before = state.kept?.get(slider.address) ?? usual;
      const isOther = state.kept && JSON.stringify(before) !== JSON.stringify(value ?? usual);
      kept.textContent = isOther ? `A: ${typeof before === "number" ? digits(out(before)) : before.kind ? "a course" : before}` : "";
    };
    range.oninput = () => { change(slider, back(+range.value)); field.value = digits(+range.value); };
    range.onkeydown = event => {
      const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!way) return;
      event.preventDefault();
      range.value = +range.value + way * (ends[1] - ends[0]) / 100;
      range.oninput();
    };
    const explain = explained(`why-${slider.address}`, row, field);
    field.oninput = () => {
      const value = back(numberIn(field)), problem = problemOf(slider, value);
      marked(field, problem !== "");
      explain(problem && `${problem} ${lastOf()}`);
      if (!problem) change(slider, value);
    };
    const lastOf = () => {
      const value = state.changed.get(slider.address);
      if (typeof value === "object" || value === undefined && slider.is_driven) return "The signal stays in use.";
      return `${digits(out(value ?? slider.value))}${unit ? ` ${unit}` : ""} stays in use.`;
    };
    field.onblur = show;
    reset.onclick = () => { state.changed.delete(slider.address); later(); };
    let seen = null, beside = null;  // no value is null
    return () => {
      const value = state.changed.get(slider.address);
      if (value === seen && state.kept === beside) return;
      [seen, beside] = [value, state.kept];
      show();
    };
  });

  function change(slider, value) {
    state.changed.set(slider.address, typeof value === "object" ? value : Math.min(slider.most, Math.max(slider.least, value)));
    later();
  }

  /* --- The course of an input over time: a table of times and values --- */

  function isCourse({ least, most }, { kind, times, values }) {
    return (kind === "steps" || kind === "points") && times.length > 0 && times.length <= MOST_POINTS && values.length === times.length
      && times.every((t, k) => Number.isFinite(t) && (k ? t > times[k - 1] : kind === "steps" ? t === 0 : t >= 0))
      && values.every(v => Number.isFinite(v) && v >= least && v <= most);
  }

  /* Table of a slider's input; the returned function shows another value. */
  function courseOf(slider, row) {
    const box = make("details", "course", row), { factor, shift, shown: unit, address } = slider;
    make("summary", "", box, "over time");
    const kind = make("select", "", box), table = make("table", "", box), head = make("tr", "", make("thead", "", table));
    kind.setAttribute("aria-label", `${address} between its times`);
    kind.add(new Option("steps", "steps"));
    kind.add(new Option("straight lines", "points"));
    for (const text of [`time [${timeName}]`, unit ? `value [${unit}]` : "value", ""]) make(text ? "th" : "td", "", head, text);
    const body = make("tbody", "", table), more = make("button", "", box, "Add a row");
    more.type = "button";
    const explain = explained(`why-course-${address}`, box);
    const places = [[t => t / timeSize, t => t * timeSize], [v => v * factor + shift, v => (v - shift) / factor]];
    const start = () => {
      const { kind, times, values } = slider.course, now = state.changed.get(address);
      return times.length && typeof now !== "number" ? { kind, rows: times.map((t, k) => [t, values[k]]) }
        : { kind, rows: [[0, typeof now === "number" ? now : slider.value]] };
    };
    let own = start(), said = null;

    const give = () => {
      const value = { kind: own.kind, times: own.rows.map(([t]) => t), values: own.rows.map(([, v]) => v) }, problems = [];
      [...body.rows].forEach((line, k) => [...line.querySelectorAll("input")].forEach((field, c) => {
        const { kind, times, values } = value, others = c ? { kind: "points", times: [0], values: [values[k]] }
          : { kind, times: times.slice(0, k + 1), values: times.slice(0, k + 1).fill(slider.value) }, isBad = !isCourse(slider, others);
        marked(field, isBad);
        const rule = k ? "enter a time after that of the row above" : kind === "steps" ? "the first time of steps is 0" : "enter a time of at least 0";
        if (isBad) problems[field === document.activeElement ? "unshift" : "push"](`Row ${k + 1}: ${c ? problemOf(slider, values[k]) : `${rule}, in ${timeName}.`}`);
      }));
      explain(problems.length ? `${problems[0]} The last valid input stays in use.` : "");
      if (isCourse(slider, value)) { said = value; change(slider, value); }
    };
    const lay = () => {
      kind.value = own.kind;
      explain("");
      body.replaceChildren();
      own.rows.forEach((pair, k) => {
        const line = make("tr", "", body);
        places.forEach(([out, back], c) => {
          const field = make("input", "", make("td", "", line));
          Object.assign(field, { type: "text", inputMode: "decimal", autocomplete: "off", value: String(+out(pair[c]).toPrecision(12)) });
          field.setAttribute("aria-label", `${address}, ${c ? "value" : "time"} ${k + 1}`);
          field.setAttribute("aria-describedby", `why-course-${address}`);
          field.oninput = () => {
            const text = field.value.trim().replace(",", ".");
            pair[c] = text === "" ? NaN : back(Number(text));
            give();
          };
        });
        const gone = make("button", "", make("td", "", line), "×");
        Object.assign(gone, { type: "button", disabled: own.rows.length < 2 });
        gone.setAttribute("aria-label", `remove row ${k + 1} of ${address}`);
        gone.onclick = () => { own.rows.splice(k, 1); lay(); give(); body.rows[Math.min(k, own.rows.length - 1)].querySelector("input").focus(); };
      });
      more.disabled = own.rows.length >= MOST_POINTS;
    };
    kind.onchange = () => { own.kind = kind.value; give(); };
    more.onclick = () => {
      const [[a, v], [b] = [0]] = [own.rows[own.rows.length - 1], own.rows[own.rows.length - 2]];
      own.rows.push([a > b ? 2 * a - b : a + end * timeSize / 10, v]);
      lay();
      give();
      body.lastChild.querySelector("input").focus();
    };
    lay();
    return value => {
      if (value === said) return;
      said = value;
      own = typeof value === "object" ? { kind: value.kind, rows: value.times.map((t, k) => [t, value.values[k]]) } : start();
      if (typeof value === "object") box.open = true;
      lay();
    };
  }

  /* --- At most one update per frame of the screen --- */

  let isAsked = false;
  function later() {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => { isAsked = false; update(); });
  }

  function update() {
    const begin = performance.now();
    if (state.kept && !state.runs.kept) {
      const kept = run(state.kept);
      state.runs.kept = { ...kept, table: kept.table.slice() };
      draw(state.runs.kept.table, true);
    }
    if (!state.kept && state.runs.kept) { state.runs.kept = null; draw(null, true); }
    const now = state.runs.now = run(state.changed);
    const took = performance.now() - begin;
    draw(now.table, false);
    for (const panel of plot.panels) for (const line of panel.spec.lines ?? [])
      if (line.isKept) panel.buttons.get(line.label).hidden = !state.kept;
    compared();
    bars();
    for (const panel of plot.panels) if (!away.has(panel)) scaled(panel);
    live();
    drawing.dim(new Set([...state.changed.keys()].filter(address => byAddress.get(address).number >= 0).map(address => address.split(".")[0])));
    for (const show of rows) show();
    const { status, accepted, attempts, reached, share } = now.ended, how = {
      done: "", stopped: ` Ended at ${digits(reached)} s, where a condition was met.`, stalled: ` The run stalled at ${digits(reached)} s.`,
      "too many": ` Given up at ${digits(reached)} s: too many steps for a page.`, "not finite": ` Not finite at ${digits(reached)} s.`,
    }[status];
    find("status").textContent = `${accepted} steps, ${attempts - accepted} rejected, ${took.toFixed(1)} ms.${how}`
      + (share < 1 ? ` With a tolerance ${1 / share} times tighter.` : "");
    find("status").classList.toggle("is-bad", status !== "done" && status !== "stopped");
    find("drop-a").hidden = find("csv-a").hidden = !state.kept;
    // A browser accepts only a hundred addresses in half a minute.
    clearTimeout(remembering);
    remembering = setTimeout(remember, 200);
    state.count = (state.count ?? 0) + 1;
  }

  /* --- Variants, link, files --- */

  find("keep").onclick = () => { state.kept = new Map(state.changed); state.runs.kept = null; later(); };
  find("drop-a").onclick = () => { state.kept = null; later(); };
  find("reset").onclick = () => { state.changed.clear(); later(); };

  let remembering = 0;
  function remember() {
    clearTimeout(remembering);
    const words = new URLSearchParams();
    const word = value => typeof value === "number" ? String(value) : [value.kind, ...value.times.map((t, k) => `${t}:${value.values[k]}`)].join(";");
    for (const [address, value] of state.changed) words.set(address, word(value));
    if (state.kept) { words.set("A", ""); for (const [address, value] of state.kept) words.set(`A:${address}`, word(value)); }
    const text = words.toString();
    if (text !== location.hash.slice(1)) history.replaceState(null, "", text ? `#${text}` : location.pathname + location.search);
  }

  /* Value in a link: a number, or a course as `steps;0:1e5;20:2e5`. */
  function read(text) {
    if (text.trim() === "") return NaN;
    if (!text.includes(";")) return Number(text);
    const [kind, ...points] = text.split(";"), pairs = points.map(point => point.split(":").map(part => part.trim() === "" ? NaN : Number(part)));
    return { kind, times: pairs.map(([t]) => t), values: pairs.map(([, v]) => v) };
  }

  function recall() {
    clearTimeout(remembering);
    const words = new URLSearchParams(location.hash.slice(1));
    state.changed = new Map();
    state.kept = words.has("A") ? new Map() : null;
    state.runs.kept = null;
    for (const [key, text] of words) {
      const isKept = key.startsWith("A:"), slider = byAddress.get(isKept ? key.slice(2) : key), value = read(text);
      const isGood = typeof value === "object" ? slider?.course && isCourse(slider, value) : value >= slider?.least && value <= slider?.most;
      if (!isGood) continue;
      (isKept ? state.kept : state.changed)?.set(slider.address, value);
    }
    draw(null, true);
  }
  addEventListener("hashchange", () => { recall(); later(); });

  find("link").onclick = async () => {
    remember();
    try { await navigator.clipboard.writeText(location.href); told("The link is copied."); }
    catch { prompt("The link", location.href); }
  };
  const told = text => { find("told").textContent = text; };
  for (const button of document.querySelectorAll("[data-copy]")) button.onclick = async () => {
    try { await navigator.clipboard.writeText(button.dataset.copy); button.textContent = "Copied"; }
    catch { getSelection().selectAllChildren(button.previousElementSibling); }
  };

  function save(name, text) {
    const link = make("a", "", document.body);
    link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    link.download = name;
    link.click();
    setTimeout(() => { URL.revokeObjectURL(link.href); link.remove(); });
  }
  const quoted = text => JSON.stringify(text).replace(/\x7f/g, "\\u007f");

  /* Parameters as TOML in SI for exact values, with a command that sets them. Signals go into a circuit file: they are
     comments, so the file contains only pairs of address and value. */
  function toml() {
    const pairs = [], signals = [];
    for (const [address, value] of state.changed) {
      const { si, factor, shift, unit, reference, is_settable: isSettable } = byAddress.get(address), isHeld = typeof value === "number";
      if (isHeld && isSettable) pairs.push([address, [value, ...si === "1" ? [] : [si], ...reference === "gauge" ? ["g"] : []].join(" "),
                                            `${digits(value * factor + shift)} ${unit}`]);
      else signals.push(`[signals.${quoted(address)}]  # values in ${si}`, `kind = "${isHeld ? "constant" : value.kind}"`,
                        ...isHeld ? [`value = ${value}`] : [`times = [${value.times.join(", ")}]`, `values = [${value.values.join(", ")}]`], "");
    }
    const lines = ["# Changed parameters of a live page. The table is an argument of Circuit.with_values."];
    if (pairs.length) lines.push("# The same values on the command line; --set also removes a signal of the input:",
                                 `# poppet simulate FILE ${pairs.map(([address, text]) => `--set ${quoted(`${address}=${text}`)}`).join(" ")}`, "");
    lines.push(...pairs.map(([address, text, seen]) => `${quoted(address)} = ${quoted(text)}  # ${seen}`));
    if (signals.length) lines.push("", "# Signals for the circuit file, in place of those under the same name:", ...signals.map(line => `# ${line}`.trimEnd()));
    return [...lines, ""].join("\n");
  }

  /* Outputs as CSV in SI, in the format of recordings. */
  function csv({ table, rows: reached, ended }) {
    const n = time.length, safe = text => /^'*[=+\-@\t\r]/.test(text) ? `'${text}` : text;
    const cell = text => /[",\n]/.test(text) ? `"${safe(text).replaceAll('"', '""')}"` : safe(text);
    const lines = [["time [s]", ...outputs.map(o => `${o.address} [${o.si}]`)].map(cell).join(",")];
    for (let j = 0; j < reached; j++) {
      const t = j === reached - 1 && ended.status !== "done" ? ended.reached : kernel.grid[j];
      lines.push([t, ...outputs.map((_, k) => table[k * n + j])].join(","));
    }
    return lines.join("\n") + "\n";
  }
  find("toml").onclick = () => save("parameters.toml", toml());
  find("csv").onclick = () => save("curves.csv", csv(state.runs.now));
  find("csv-a").onclick = () => save("curves_A.csv", csv(state.runs.kept));

  /* --- Measured values --- */

  function parsed(text) {
    const lines = text.replace(/^\ufeff/, "").split(/\r?\n/).filter(line => line.trim() && !line.startsWith("#"));
    if (lines.length < 3) throw new Error("fewer than two rows");
    const count = sign => lines[0].split(sign).length, sign = ["\t", ";", ","].reduce((a, b) => count(b) > count(a) ? b : a);
    const cells = line => line.split(sign).map(cell => cell.trim().replace(/^"(.*)"$/, "$1").replace(/^'(?='*[=+\-@\t\r])/, ""));
    const number = cell => cell === "" ? NaN : Number(sign === "," ? cell : cell.replace(",", "."));
    const heads = cells(lines[0]).map(head => {
      const found = /^(.*?)\s*[[(]([^\])]*(?:\([^)]*\))?[^\])]*)[\])]\s*$/.exec(head);
      return found ? { name: found[1], unit: found[2].trim() } : { name: head, unit: "" };
    });
    const table = lines.slice(1).map(line => cells(line).map(number));
    return heads.map((head, k) => ({ ...head, values: table.map(row => row[k] ?? NaN) }));
  }

  function scaleOf(si, unit) {
    const known = header.units[si] ?? [[si, 1, 0]], plain = text => text.replace(/\s|\(|\)/g, "").replace("°", "deg");
    return known.find(([name]) => plain(name) === plain(unit)) ?? (unit === "" ? [si, 1, 0] : null);
  }

  function measured(name, text) {
    let columns;
    try { columns = parsed(text); } catch (problem) { told(`${name} is no table of numbers: ${problem.message}.`); return; }
    const clockColumn = columns.find(c => /^(time|t|zeit)$/i.test(c.name)) ?? columns[0], scale = scaleOf("s", clockColumn.unit);
    if (!scale) { told(`${name}: its time is in ${clockColumn.unit}, which is no time here.`); return; }
    const at = clockColumn.values.map(v => (v * scale[1] + scale[2]) / timeSize);
    for (const column of columns) {
      if (column === clockColumn) continue;
      const item = { ...column, file: name, at, output: outputs.findIndex(o => o.address === column.name && scaleOf(o.si, column.unit)) };
      state.measured.push(item);
    }
    told("");
    listed();
  }

  const nameOf = item => item.unit ? `${item.name} [${item.unit}]` : item.name;

  function listed() {
    const list = find("measured");
    list.replaceChildren();
    for (const item of state.measured) {
      const row = make("div", "row measured", list), choice = make("select", "", row);
      make("label", "", row, nameOf(item));
      choice.setAttribute("aria-label", `what ${item.name} measures`);
      choice.add(new Option("not compared", "-1"));
      outputs.forEach((o, k) => { if (scaleOf(o.si, item.unit)) choice.add(new Option(o.address, String(k))); });
      choice.value = String(item.output);
      choice.onchange = () => { item.output = +choice.value; overlaid(item); later(); };
      item.rms = make("output", "", row);
      const gone = make("button", "", row, "×");
      gone.setAttribute("aria-label", `remove ${item.name}`);
      gone.onclick = () => { state.measured = state.measured.filter(one => one !== item); item.output = -1; overlaid(item); listed(); };
      overlaid(item);
    }
    later();
  }

  /* A measured series as a line in the panel of its output. */
  function overlaid(item) {
    for (const panel of plot.panels) if (panel.spec.lines) {
      if (panel.spec.lines.includes(item.line)) { panel.buttons.get(item.line.label)?.remove(); panel.buttons.delete(item.line.label); panel.keys.delete(item.line.label); }
      panel.spec.lines = panel.spec.lines.filter(line => line !== item.line);
    }
    item.line = null;
    if (item.output < 0) return;
    const { si, factor, shift } = outputs[item.output], scale = scaleOf(si, item.unit);
    const y = item.values.map(v => Number.isFinite(v) ? (v * scale[1] + scale[2]) * factor + shift : null);
    item.y = y;
    const panel = plot.panels.find(one => lineOf(one, item.output));
    if (!panel) return;
    item.line = { label: `measured: ${item.name}`, colour: "#111111", alpha: .75, width: .8, dash: [2, 2], x: item.at, y, isOrdered: true };
    panel.spec.lines.push(item.line);
    panel.addKey(item.line);
  }

  /* Root mean square of model minus measurement over the time of the run. */
  function compared() {
    for (const item of state.measured) {
      if (!item.rms) continue;
      if (item.output < 0) { item.rms.textContent = ""; continue; }
      const words = [["rms", state.runs.now], ...state.kept ? [["A", state.runs.kept]] : []].map(([word, one]) => {
        const own = shown(one.table, item.output), last = one.rows - 1;
        let sum = 0, count = 0, k = 0;
        item.at.forEach((t, j) => {
          if (item.y[j] === null || !(t >= 0 && t <= time[last])) return;
          while (k > 0 && time[k] > t) k--;
          while (k < last - 1 && time[k + 1] <= t) k++;
          const model = last ? own[k] + (own[k + 1] - own[k]) * (t - time[k]) / (time[k + 1] - time[k]) : own[0];
          sum += (model - item.y[j]) ** 2;
          count++;
        });
        return count ? `${word} ${digits(Math.sqrt(sum / count))}` : `${word} -`;
      });
      item.rms.textContent = `${words.join(", ")} ${outputs[item.output].unit}`;
    }
  }

  addEventListener("dragover", event => { event.preventDefault(); document.body.classList.add("is-over"); });
  addEventListener("dragleave", () => document.body.classList.remove("is-over"));
  addEventListener("drop", async event => {
    event.preventDefault();
    document.body.classList.remove("is-over");
    for (const file of event.dataTransfer.files) measured(file.name, await file.text());
  });
  find("file").onchange = async event => { for (const file of event.target.files) measured(file.name, await file.text()); event.target.value = ""; };

  /* --- Begin --- */

  recall();
  update();
  document.body.classList.add("is-ready");
  globalThis.live = { state, kernel, update, change: (address, value) => change(byAddress.get(address), value), toml, csv: () => csv(state.runs.now), measured, header, remember };
})().catch(problem => {
  console.error(problem);
  document.getElementById("status").textContent = `This browser cannot run the model: ${problem.message}.`;
});
