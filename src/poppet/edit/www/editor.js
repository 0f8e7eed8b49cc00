/* Page of the editor: connects the modules, the toolbar and the keys. */

import { Banners } from "./banners.js";
import { Curves } from "./curves.js";
import { showHelp, askFileName } from "./dialogs.js";
import { Drawing } from "./drawing.js";
import { Form } from "./form.js";
import { listenToKeys } from "./keys.js";
import { closeMenus } from "./menus.js";
import { Palette } from "./palette.js";
import { Panels } from "./panels.js";
import { Problems } from "./problems.js";
import { Run } from "./run.js";
import { StartPage } from "./start.js";
import { Store } from "./store.js";
import { fillTexts, loadLanguage, text } from "./strings.js";
import { Tasks } from "./tasks.js";
import { TextPanel } from "./text.js";

const find = id => document.getElementById(id);
const store = new Store();

// For programs that control the page; `store` is the state, for tests of the page itself.
window.poppet = {
  store,
  text: () => store.text(),
  recording: () => store.recording(),
  get ready() { return store.ready; },
};

/* Commands of the toolbar and of the keys. */
function commandsOf(drawing, palette, curves, start) {
  return {
    save: () => store.save(),
    saveAs: () => askFileName(store),
    undo: () => store.undo(),
    redo: () => store.redo(),
    rotate: () => drawing.rotate(),
    mirror: () => drawing.mirror(),
    remove: () => drawing.remove(),
    zoom: factor => drawing.zoom(factor),
    help: () => showHelp(),
    open: () => start.open(),
    search: () => palette.search(),
    play: () => curves.toggle(),
    copyText: async () => {
      await navigator.clipboard.writeText(store.text());
      store.announce(text("toolbar.copied"));
    },
  };
}

/* Connect the buttons of the toolbar with commands. */
function connectToolbar(commands) {
  const buttons = {
    save: commands.save, "save-as": commands.saveAs, open: commands.open, "copy-text": commands.copyText, undo: commands.undo,
    redo: commands.redo, rotate: commands.rotate, mirror: commands.mirror, delete: commands.remove, help: commands.help,
    "zoom-in": () => commands.zoom(1.25), "zoom-out": () => commands.zoom(0.8), "zoom-fit": () => commands.zoom(null),
  };
  for (const [id, command] of Object.entries(buttons)) {
    find(id).addEventListener("click", () => {
      find("file-menu").open = false;
      command();
    });
  }
  const update = () => {
    const { can_undo, can_redo } = store.state ?? {};
    find("undo").disabled = !can_undo;
    find("redo").disabled = !can_redo;
    const nothing = !store.selection.size && !store.wire;
    for (const id of ["rotate", "mirror"]) find(id).disabled = !store.selection.size;
    find("delete").disabled = nothing;
  };
  for (const event of ["state", "selection"]) store.addEventListener(event, update);
  update();
}

/* Show name and changes of the circuit in the title. */
function showTitle() {
  const { name, dirty, view } = store.state ?? {};
  const shown = name ?? text("page.unnamed");
  find("name").textContent = dirty ? `${shown} *` : shown;
  find("name").title = view?.title ?? "";
  document.title = text(dirty ? "page.title_dirty" : "page.title", { name: shown });
}

/* Build the page; modules that fail leave the others usable. */
async function begin() {
  document.documentElement.lang = await loadLanguage(navigator.languages);
  fillTexts(document);
  const made = make => {
    try {
      return make();
    } catch (problem) {
      console.error(problem);
      return null;
    }
  };
  const drawing = made(() => new Drawing(find("drawing"), store));
  const palette = made(() => new Palette(find("palette"), store, drawing));
  const curves = made(() => new Curves(find("curves"), store));
  made(() => new Form(find("form"), store));
  made(() => new Run(find("run"), store));
  const textPanel = made(() => new TextPanel(find("text"), store));
  made(() => new Tasks(find("tasks"), store));
  const start = new StartPage(find("start"), store);
  const commands = commandsOf(drawing, palette, curves, start);
  const panels = new Panels(store);
  new Problems(find("problems"), store, line => {
    panels.showSide("text");
    textPanel?.goTo(line);
  });
  new Banners(find("banners"), store, commands);
  connectToolbar(commands);
  listenToKeys(commands, drawing);
  closeMenus();
  store.addEventListener("message", () => { find("announce").textContent = store.message; });
  store.addEventListener("state", showTitle);
  showTitle();
  addEventListener("beforeunload", event => { if (store.state?.dirty || textPanel?.isDirty) event.preventDefault(); });
  await store.load();
}

begin();
