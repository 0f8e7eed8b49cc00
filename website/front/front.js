/* Model of the front page: two sliders, a drawing that moves, and a plot; the kernel is that of the live pages. */
(async () => {
  const { header, blobs } = await unpacked(document.getElementById("model").textContent);
  const kernel = await Kernel.of({ header, blobs });
  const find = id => document.getElementById(id), { outputs, pilot, volume } = header;
  const DURATION_OF_PLAY = 9000, BAR = 1e5, SVG = "http://www.w3.org/2000/svg";
  const time = kernel.grid, end = time[time.length - 1];
  const state = { table: null, first: null, at: 0, isPlaying: false, count: 0 };
  const names = Object.keys(outputs), column = name => state.table.subarray(outputs[name] * time.length, (outputs[name] + 1) * time.length);

  /* --- Runs --- */

  /* The signal of the file, with the height of its steps multiplied. */
  function pilotRows(highest) {
    const { times, values, ambient } = pilot, factor = (highest - ambient) / (Math.max(...values) - ambient);
    return times.map((t, k) => [t, ambient + factor * (values[k] - ambient), 0, k > 0]);
  }

  function run() {
    const values = [...kernel.map.values];
    values[volume.number] = +find("volume").value / 1000;
    kernel.run(...kernel.changes(values, [[pilot.input, pilotRows((+find("pilot").value) * BAR + pilot.ambient), 0]]));
    state.table = kernel.table.slice();
    state.first ??= state.table;
    state.count++;
    find("pilot-shown").textContent = `${(+find("pilot").value).toFixed(1)} bar g`;
    find("volume-shown").textContent = `${find("volume").value} l`;
    drawPlot();
    show();
  }

  /* Value of an output at a time, linear between rows. */
  function valueAt(name, at, table = state.table) {
    const last = time.length - 1, place = Math.min(last, at / end * last), k = Math.min(last - 1, Math.floor(place));
    const offset = outputs[name] * time.length + k;
    return table[offset] + (table[offset + 1] - table[offset]) * (place - k);
  }

  /* --- Drawing --- */

  const flowed = { fill: 0, exhaust: 0, leak: 0 };
  function show(elapsed = 0) {
    const now = Object.fromEntries(names.map(name => [name, valueAt(name, state.at)]));
    const bar = value => `${(value / BAR).toFixed(2)} bar`, shade = value => Math.min(1, value / (7 * BAR));
    // Small negative strokes, which open the exhaust, are enlarged.
    const shift = now.stroke < 0 ? Math.max(-14, now.stroke * 7e5) : Math.min(15, now.stroke * 3e4);
    find("poppet").setAttribute("transform", `translate(0 ${shift.toFixed(2)})`);
    find("pilot-gas").setAttribute("height", (22 + shift).toFixed(2));
    find("pilot-gas").style.opacity = shade(now.pilot);
    for (const id of ["tank-gas", "outlet-gas"]) find(id).style.opacity = shade(now.tank);
    for (const [name, flow] of [["fill", now.fill], ["exhaust", now.exhaust], ["leak", now.leak]]) {
      const line = find(`${name}-flow`);
      flowed[name] += elapsed * 4000 * Math.min(.015, Math.abs(flow));
      line.style.opacity = Math.abs(flow) > 2e-5 ? 1 : 0;
      line.style.strokeWidth = 1.5 + 1.5 * Math.min(1, Math.abs(flow) / .01);
      line.style.strokeDashoffset = -flowed[name];
    }
    const scale = Math.cbrt(+find("volume").value / volume.high);
    find("tank").setAttribute("transform", `translate(232 81.5) scale(${scale.toFixed(3)}) translate(-232 -81.5)`);
    const [x, y] = [232 + 45 * scale, 81.5 + 39.5 * scale];
    find("leak-flow").setAttribute("d", `M${x} ${y - 4}v20`);
    find("leak-label").setAttribute("x", x + 7);
    find("leak-label").setAttribute("y", y + 14);
    find("supply-value").textContent = `${(now.supply / BAR).toFixed(0)} bar`;
    find("pilot-value").textContent = bar(now.pilot);
    find("tank-value").textContent = bar(now.tank);
    find("temperature-value").textContent = `${(now.temperature - 273.15).toFixed(0)} °C`;
    showCursor(now);
  }

  /* --- Plot --- */

  const plot = find("plot"), margin = { left: 30, right: 10, top: 24, bottom: 34 };
  const shape = (tag, attributes, text) => {
    const element = document.createElementNS(SVG, tag);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    if (text !== undefined) element.textContent = text;
    return plot.appendChild(element);
  };
  let scaleX, scaleY, cursor, width, height;

  function line(name, table) {
    const points = [];
    for (let k = 0; k < time.length; k++) points.push(`${scaleX(time[k]).toFixed(1)} ${scaleY(table[outputs[name] * time.length + k] / BAR).toFixed(1)}`);
    return `M${points.join("L")}`;
  }

  function drawPlot() {
    plot.replaceChildren();
    [width, height] = [plot.clientWidth, plot.clientHeight];
    plot.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const highest = Math.max(...column("tank"), ...column("pilot"), ...state.first.subarray(outputs.tank * time.length, (outputs.tank + 1) * time.length)) / BAR;
    const step = highest > 4 ? 2 : 1, top = Math.ceil(highest / step + .05) * step;
    scaleX = t => margin.left + (width - margin.left - margin.right) * t / end;
    scaleY = v => height - margin.bottom - (height - margin.top - margin.bottom) * v / top;
    for (let v = 0; v <= top; v += step) {
      shape("path", { class: v ? "grid" : "axis", d: `M${margin.left} ${scaleY(v)}H${width - margin.right}` });
      shape("text", { x: margin.left - 6, y: scaleY(v) + 4, class: "end" }, v);
    }
    for (let t = 0; t <= end; t += width < 400 ? 40 : 20)
      shape("text", { x: scaleX(t), y: height - margin.bottom + 16, class: t === end ? "end" : "middle" }, t);
    shape("text", { x: margin.left + (width - margin.left - margin.right) / 2, y: height - 2, class: "middle" }, "time [s]");
    shape("text", { x: 2, y: 13, class: "name" }, "pressure [bar, absolute]");
    shape("path", { class: "curve first", d: line("tank", state.first) });
    shape("path", { class: "curve pilot", d: line("pilot", state.table) });
    shape("path", { class: "curve tank", d: line("tank", state.table) });
    let x = width - margin.right;
    for (const [name, text] of [["pilot", "pilot"], ["tank", "tank"]]) {
      const label = shape("text", { x, y: 13, class: `end key ${name}` }, text);
      x -= label.getComputedTextLength() + 8;
      shape("path", { class: `curve ${name}`, d: `M${x - 14} 9h16` });
      x -= 26;
    }
    cursor = { line: shape("path", { class: "cursor" }), tank: shape("circle", { r: 4, class: "dot tank" }), pilot: shape("circle", { r: 3, class: "dot pilot" }) };
  }

  function showCursor(now) {
    const x = scaleX(state.at).toFixed(1);
    cursor.line.setAttribute("d", `M${x} ${margin.top}V${height - margin.bottom}`);
    for (const name of ["tank", "pilot"]) { cursor[name].setAttribute("cx", x); cursor[name].setAttribute("cy", scaleY(now[name] / BAR).toFixed(1)); }
  }

  /* --- Time: play, or the time under the pointer --- */

  let last = 0;
  function frame(now) {
    if (!state.isPlaying) return;
    const elapsed = Math.min(100, now - last);
    last = now;
    state.at = (state.at + elapsed / DURATION_OF_PLAY * end) % end;
    show(elapsed / 1000 * end / (DURATION_OF_PLAY / 1000) / 13);
    requestAnimationFrame(frame);
  }
  function play(isPlaying) {
    state.isPlaying = isPlaying;
    find("play").textContent = isPlaying ? "Pause" : "Play";
    last = performance.now();
    if (isPlaying) requestAnimationFrame(frame);
  }
  find("play").onclick = () => play(!state.isPlaying);
  plot.addEventListener("pointermove", event => {
    if (event.pointerType === "mouse" && !event.buttons) return;
    const share = (event.clientX - plot.getBoundingClientRect().left - margin.left) / (width - margin.left - margin.right);
    play(false);
    state.at = end * Math.min(1, Math.max(0, share));
    show();
  });

  for (const id of ["pilot", "volume"]) find(id).addEventListener("input", run);
  new ResizeObserver(() => { if (plot.clientWidth !== width || plot.clientHeight !== height) { drawPlot(); show(); } }).observe(plot);
  run();
  state.at = .3 * end;
  show();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
  globalThis.front = state;
  performance.mark("first-plot");
})().catch(problem => {
  console.error(problem);
  document.getElementById("model-problem").textContent = `This browser cannot run the model: ${problem.message}.`;
});
