// Names for what the theme leaves without one, for those who hear a page.
window.addEventListener("load", () => {
  for (const summary of document.querySelectorAll("details > summary")) {
    if (summary.innerText.trim()) {
      summary.removeAttribute("aria-label");
      continue;
    }
    const link = summary.closest("li")?.querySelector("a");
    summary.setAttribute("aria-label", `Pages below ${link ? link.textContent.trim() : "this"}`);
  }
  for (const button of document.querySelectorAll("button.search-button__button")) {
    button.setAttribute("aria-label", button.innerText.replace(/\s+/g, " ").trim() || "Search");
  }
});
// On a telephone, the rows of tables with few columns are cards: each cell has the name of its column.
window.addEventListener("DOMContentLoaded", () => {
  for (const table of document.querySelectorAll(".bd-article table:not(.dataframe)")) {
    const names = [...table.querySelectorAll("thead th")].map(cell => cell.textContent.trim());
    if (!names.length || names.length > 5) continue;
    table.classList.add("cards");
    for (const row of table.tBodies[0].rows) {
      // Two columns are clear without names.
      if (names.length > 2) [...row.cells].forEach((cell, k) => { if (k && names[k]) cell.dataset.name = names[k]; });
    }
  }
});
// A button with a command copies it; if the browser does not permit this, the command is selected.
document.addEventListener("click", async event => {
  const button = event.target.closest("[data-copy]");
  if (!button) return;
  try {
    await navigator.clipboard.writeText(button.dataset.copy);
    button.textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(button.previousElementSibling);
  }
});
// Paper is light: the theme of the screen returns after printing.
matchMedia("print").addEventListener("change", ({ matches }) => {
  const { dataset } = document.documentElement;
  if (matches) [dataset.screen, dataset.theme] = [dataset.theme, "light"];
  else dataset.theme = dataset.screen;
});
