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
