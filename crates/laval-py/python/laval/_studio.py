"""The studio of a machine, from Python: a page that answers while the machine is changed."""

from __future__ import annotations

import os
from typing import Any

from laval import _native
from laval._machine import Machine, loads

_FRAME = """
function render({ model, el }) {
  const frame = document.createElement("iframe");
  frame.src = model.get("address");
  frame.title = "laval studio";
  frame.style.cssText = `width:100%;height:${model.get("height")}px;border:1px solid #8884`;
  el.append(frame);
}
export default { render };
"""


class Studio:
    """A studio that is open: its page in the browser, or in the notebook, and what was changed there.

    Ends with :meth:`stop`, at the end of a ``with`` block, or with Python.
    """

    def __init__(self, native: _native.Studio, machine: Machine, height: int) -> None:
        self._native = native
        self._opened = machine
        self._height = height

    @property
    def address(self) -> str:
        """The address of the page, on this computer alone. Whoever knows it can use the studio."""
        return self._native.address

    @property
    def text(self) -> str:
        """The machine file with all changes of the page so far."""
        return self._native.text() or self._opened.text

    @property
    def machine(self) -> Machine:
        """The machine of :attr:`text`.

        Raises:
            MachineError: the text has mistakes.
        """
        return loads(self.text)

    def stop(self) -> None:
        """Ends the studio."""
        self._native.stop()

    def __enter__(self) -> Studio:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"<laval.Studio of {self._opened.name!r}: {self.address}>"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        widget = _widget(self.address, self._height)
        return {"text/plain": repr(self)} if widget is None else widget._repr_mimebundle_(**kwargs)


def _widget(address: str, height: int) -> Any:
    """The page in a frame; none without anywidget."""
    try:
        import anywidget
        import traitlets
    except ImportError:
        return None
    members = {
        "_esm": _FRAME,
        "address": traitlets.Unicode(address).tag(sync=True),
        "height": traitlets.Int(height).tag(sync=True),
    }
    return type("StudioFrame", (anywidget.AnyWidget,), members)()


def _notebook() -> bool:
    """The program runs in a notebook that can show widgets."""
    try:
        import anywidget  # noqa: F401
        from IPython import get_ipython
    except ImportError:
        return False
    shell = get_ipython()
    return shell is not None and hasattr(shell, "kernel")


def studio(machine: Machine | str, *, browser: bool | None = None, height: int = 720, language: str = "en") -> Studio:
    """Opens a machine in the studio: in the notebook where anywidget is installed, else in the browser.

    >>> studio = laval.studio(machine)      # drag, type, compare
    >>> machine = studio.machine            # with all changes

    The page is served on this computer alone. Files are saved in the current folder.

    Args:
        machine: the machine, or the text of a machine file.
        browser: open the browser; by default where no notebook shows the page.
        height: of the page in a notebook, in pixels.
        language: ``en``, ``ru``, ``kk`` or ``uz``.

    Raises:
        ValueError: a language that is none of these.
    """
    opened = machine if isinstance(machine, Machine) else loads(machine)
    name = os.path.basename(opened._core.origin) or "machine.toml"
    if not name.endswith(".toml"):
        name = "machine.toml"
    found = Studio(_native.studio(opened.text, name, os.getcwd(), language), opened, height)
    if browser if browser is not None else not _notebook():
        import webbrowser

        webbrowser.open(found.address)
    return found
