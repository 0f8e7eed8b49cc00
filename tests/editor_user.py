"""A user of the editor, by mouse or by keyboard alone, and the time that a person takes for the same actions."""

from __future__ import annotations

import os
import time

from editor_page import Editor

KEY, POINT, CLICK, HOME, THINK = 0.28, 1.10, 0.20, 0.40, 1.35
"""Times of the keystroke-level model [s] (Card, Moran and Newell, 1980): a key of a typist with 40 words per minute,
pointing with a mouse, a click, moving a hand between mouse and keyboard, and a mental preparation."""
PACE = float(os.environ.get("POPPET_PACE", "0"))
"""Fraction of these times during which a script pauses; 1 is the pace of a person."""
MOST_TABS = 300
WHERE = """selector => {
  const here = document.activeElement, wanted = document.querySelector(selector);
  if (here.matches(selector)) return "here";
  return wanted && here.compareDocumentPosition(wanted) & Node.DOCUMENT_POSITION_PRECEDING ? "before" : "after";
}"""


class User:
    """Actions on a page, with the time that a person takes for them.

    Attributes
    ----------
    seconds : float
        Time of a person for the actions until now, by the keystroke-level model.
    pointer : tuple of float
        Last position of the mouse.
    """

    def __init__(self, editor: Editor) -> None:
        self.editor, self.page, self.seconds = editor, editor.page, 0.0
        self.pointer = (0.0, 0.0)

    def watch(self) -> None:
        """Do nothing; called after each action, for example to film it."""

    def _take(self, seconds: float) -> None:
        self.seconds += seconds
        if PACE > 0.0:
            time.sleep(PACE * seconds)

    def add(self, kind: str) -> None:
        """Add a part from the palette."""
        raise NotImplementedError

    def connect(self, start: str, end: str) -> None:
        """Connect a port with another port or with a part."""
        raise NotImplementedError

    def select(self, name: str) -> None:
        """Select a part."""
        raise NotImplementedError

    def type(self, field: str, value: str) -> None:
        """Enter a value of the selected part."""
        raise NotImplementedError

    def signal(self, address: str, kind: str) -> None:
        """Select the kind of signal of an input of the selected part."""
        raise NotImplementedError

    def save(self) -> None:
        """Save the file."""
        raise NotImplementedError


class MouseUser(User):
    """A user who points and clicks, and types values only."""

    def _click(self, place: tuple[float, float]) -> None:
        self._take(THINK + POINT + CLICK)
        self.pointer = place
        self.page.mouse.click(*place)
        self.editor.wait()
        self.watch()

    def add(self, kind: str) -> None:
        self._click(self.editor.centre(self.editor.palette(kind)))

    def connect(self, start: str, end: str) -> None:
        editor = self.editor
        for name in (start, end):
            self._click(editor.centre(editor.port(name) if "." in name else editor.part(name)))

    def select(self, name: str) -> None:
        self._click(self.editor.centre(self.editor.part(name)))

    def type(self, field: str, value: str) -> None:
        element = self.editor.field(field)
        element.scroll_into_view_if_needed()
        self.pointer = self.editor.centre(element)
        self.page.mouse.click(*self.pointer, click_count=3)  # selects the old value
        self._take(THINK + POINT + 3 * CLICK + HOME + KEY * (len(value) + 1) + HOME)
        self.page.keyboard.type(value)
        self.page.keyboard.press("Enter")
        self.editor.wait()
        self.watch()

    def signal(self, address: str, kind: str) -> None:
        element = self.page.get_by_label(f"Signal of {address}", exact=True)
        element.scroll_into_view_if_needed()
        self.pointer = self.editor.centre(element)
        element.select_option(kind)
        self._take(2.0 * (THINK + POINT + CLICK))
        self.editor.wait()
        self.watch()

    def save(self) -> None:
        self._click(self.editor.centre(self.editor.button("Save")))


class KeyboardUser(User):
    """A user without a mouse.

    A person holds the Tab key down to move on. The key repeats 30 times per second.
    """

    def press(self, key: str) -> None:
        """Press a key."""
        self._take(KEY)
        self.page.keyboard.press(key)

    def _go(self, selector: str) -> None:
        """Press Tab or Shift+Tab until an element has the focus."""
        self._take(THINK)
        for _ in range(MOST_TABS):
            where = self.page.evaluate(WHERE, selector)
            if where == "here":
                return
            self._take(1.0 / 30.0)
            self.page.keyboard.press("Tab" if where == "after" else "Shift+Tab")
        raise AssertionError(f"{selector} is not reached by Tab")

    def _type(self, value: str) -> None:
        self.press("Control+a")
        self._take(KEY * len(value))
        self.page.keyboard.type(value)
        self.press("Enter")
        self.editor.wait()

    def add(self, kind: str) -> None:
        self._take(THINK)
        self.press("Escape")  # out of the field
        self.press("Escape")
        self.press("/")
        self._type(kind)

    def connect(self, start: str, end: str) -> None:
        self.select(start.partition(".")[0])
        self._go(f'[data-port="{start}"]')
        self.press("Enter")
        self._go(f'[data-port="{end}"]' if "." in end else f'[data-part="{end}"]')
        self.press("Enter")
        self.editor.wait()

    def select(self, name: str) -> None:
        self._go(f'[data-part="{name}"]')
        self.press("Enter")

    def type(self, field: str, value: str) -> None:
        self._go(f'input[name="{field}"]')
        self._type(value)

    def signal(self, address: str, kind: str) -> None:
        self._go(f'[aria-label="Signal of {address}"]')
        self._take(KEY * len(kind))
        self.page.keyboard.type(kind)
        self.editor.wait()

    def save(self) -> None:
        self.press("Control+s")
        self.editor.wait()


def draw_cylinder_drive(user: User) -> None:
    """Draw a cylinder with a 5/2 valve and two flow controls, which moves a mass, on an empty page."""
    for kind in ("reservoir", "spool_valve", "flow_control_valve", "flow_control_valve", "cylinder", "mass"):
        user.add(kind)
    user.connect("spool_valve.supply", "reservoir")
    # Between two ports, the editor inserts a chamber: the volume of the hose.
    user.connect("spool_valve.a", "flow_control_valve.from")
    user.connect("spool_valve.b", "flow_control_valve_2.from")
    user.connect("flow_control_valve.to", "cylinder.cap")
    user.connect("flow_control_valve_2.to", "cylinder.rod")
    user.connect("cylinder.body", "mass")
    user.select("spool_valve")
    user.signal("spool_valve.command", "steps")  # after a quarter of the run
    user.select("mass")
    user.type("mass.mass", "6 kg")
    user.save()
