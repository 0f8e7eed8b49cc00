/* Tabs: those of the right column, and on a narrow page those of all panels. */

import { text } from "./strings.js";

const PANELS = ["palette", "drawing", "curves", "side"];  // on a narrow page
const SIDE = ["form", "run", "text", "tasks"];
const NARROW = "(max-width: 60rem)";

/* Tab lists of the page. A part that is selected shows its properties; on a narrow page, a new part shows the drawing. */
export class Panels {
  constructor(store) {
    this.panels = tabList("panel-tabs", PANELS, name => text(`page.panel_${name}`), name => { document.body.dataset.panel = name; });
    this.side = tabList("side-tabs", SIDE, name => text(`page.${name}`), name => {
      for (const panel of SIDE) document.getElementById(panel).hidden = panel !== name;
    });
    this.panels("drawing");
    this.side("form");
    for (const name of SIDE) {
      const panel = document.getElementById(name);
      panel.setAttribute("role", "tabpanel");
      panel.setAttribute("aria-labelledby", `side-tabs-${name}`);
    }
    store.addEventListener("selection", () => { if (store.selection.size === 1) this.side("form"); });
    store.addEventListener("state", () => {
      if (store.state.created?.length && matchMedia(NARROW).matches) this.panels("drawing");
    });
  }

  /* Show a tab of the right column, also on a narrow page. */
  showSide(name) {
    this.panels("side");
    this.side(name);
  }
}

/* Fill a tab list; the returned function selects a tab. */
function tabList(id, names, label, show) {
  const list = document.getElementById(id);
  const tabs = names.map(name => {
    const tab = document.createElement("button");
    Object.assign(tab, { type: "button", id: `${id}-${name}`, textContent: label(name) });
    tab.setAttribute("role", "tab");
    if (document.getElementById(name)) tab.setAttribute("aria-controls", name);
    tab.onclick = () => select(name);
    list.append(tab);
    return tab;
  });
  const select = name => {
    tabs.forEach((tab, k) => {
      tab.setAttribute("aria-selected", String(names[k] === name));
      tab.tabIndex = names[k] === name ? 0 : -1;
    });
    show(name);
  };
  list.onkeydown = event => {
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!way) return;
    event.preventDefault();
    const next = tabs[(tabs.indexOf(event.target) + way + tabs.length) % tabs.length];
    next.click();
    next.focus();
  };
  return select;
}
