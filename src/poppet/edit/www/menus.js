/* Menus: a `details` element of the class "menu" closes as users expect of a menu. */

/* Close menus by a click elsewhere, by Escape, and when another one opens. */
export function closeMenus() {
  const openMenus = () => [...document.querySelectorAll("details.menu[open]")];
  document.addEventListener("pointerdown", event => {
    for (const menu of openMenus()) if (!menu.contains(event.target)) menu.open = false;
  });
  document.addEventListener("keydown", event => {
    if (event.key !== "Escape") return;
    for (const menu of openMenus()) {
      menu.open = false;
      menu.querySelector("summary").focus();
      event.stopPropagation();
    }
  }, { capture: true });
}
