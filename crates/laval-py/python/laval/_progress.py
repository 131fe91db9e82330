"""How far a run is: a bar of tqdm, or a function of the user."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Union

if TYPE_CHECKING:
    from typing import TypeAlias

Follow: TypeAlias = Callable[[str, float, int], Any]
Progress: TypeAlias = Union[bool, Follow, None]


@contextmanager
def shown(progress: Progress) -> Iterator[Follow | None]:
    """What is called while a run lasts: name of the study, steps done, all steps (0: unknown)."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        bar = _Bar()
        try:
            yield bar
        finally:
            bar.close()
    else:
        yield progress


class _Bar:
    """One bar, begun anew for every study."""

    def __init__(self) -> None:
        from tqdm.auto import tqdm

        self._new = tqdm
        self._bar: Any = None
        self._study: str | None = None

    def __call__(self, study: str, done: float, total: int) -> None:
        if study != self._study:
            self.close()
            self._bar = self._new(desc=study, total=total or None, unit="step")
            self._study = study
        if total and self._bar.total != total:
            self._bar.reset(total=total)
        self._bar.n = done
        self._bar.refresh()

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
