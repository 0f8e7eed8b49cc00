/* Keys of the page. Keys act only where the focus is: in fields and dialogs, only Ctrl+S and Escape do. */

/* Connect the keys with commands; the drawing handles its own keys. */
export function listenToKeys(commands, drawing) {
  document.addEventListener("keydown", event => {
    if (event.defaultPrevented || !(event.target instanceof Element)) return;
    if (isControl(event) && event.key.toLowerCase() === "s") {
      event.preventDefault();
      // As if the focus left the field, so that the file contains the typed value.
      if (event.target.matches("input[type=text], textarea")) event.target.dispatchEvent(new Event("change", { bubbles: true }));
      commands.save();
    } else if (isField(event.target)) {
      if (event.key === "Escape") leaveField(event.target);
    } else if (!event.target.closest("dialog") && (pageKey(event, commands) || isForDrawing(event) && drawing?.onKey(event))) {
      event.preventDefault();
    }
  });
}

/* Leave a field; the focus goes from the form to its part in the drawing. */
function leaveField(field) {
  const part = field.closest("#form") ? field.name.split(".")[0] : "";
  field.blur();
  if (part) document.querySelector(`#drawing [data-part="${CSS.escape(part)}"]`)?.focus();
}

/* Perform a key of the page; the result is false if the key is not one. */
function pageKey(event, { undo, redo, help, search, play }) {
  const key = event.key.toLowerCase();
  if (isControl(event)) {
    if (key === "z") (event.shiftKey ? redo : undo)();
    else if (key === "y") redo();
    else return false;
    return true;
  }
  if (event.altKey) return false;
  if (key === "?") help();
  else if (key === "/") search();
  else if (key === " " && !event.target.closest("button, summary, [role=button], [role=tab], a")) play();
  else return false;
  return true;
}

function isControl(event) { return (event.ctrlKey || event.metaKey) && !event.altKey; }

function isField(element) {
  return element.matches("textarea, select, input:not([type=checkbox], [type=radio], [type=button], [type=range])") || element.isContentEditable;
}

/* Enter, Space and arrows belong to buttons, tabs and sliders outside the drawing. */
function isForDrawing(event) {
  if (event.target.closest("#drawing") || event.target === document.body) return true;
  const isOwn = /^(Enter| |Tab|Arrow\w+|Home|End|Page\w+)$/.test(event.key);
  return !isOwn && !event.target.closest("input, summary, [role=tab]");
}
