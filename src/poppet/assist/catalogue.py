"""Function `find_components`: search in the components of the library."""

from __future__ import annotations

from typing import Annotated

from poppet.assist.arguments import Argument
from poppet.assist.folder import Folder
from poppet.assist.limits import LIST_ROWS
from poppet.assist.replies import Json
from poppet.core.errors import InputError


def find_components(
    folder: Folder,
    conditions: Annotated[str, Argument('conditions: "5/2, C > 3 dm^3/(s bar)"', longest=200)],
) -> Json:
    """Find components by their properties: model for the field `model` of a part, numbers, document and doubts."""
    from poppet.library.components import components
    from poppet.parts import KINDS
    from poppet.parts.component_search import search
    from poppet.parts.components import numbers_of

    try:
        matches = search(conditions, components())
    except InputError as error:
        raise error.located(address="conditions") from None
    rows = [
        {
            "model": component.names[0],
            "kinds": list(component.kinds),
            "numbers": {
                name: number.display()
                for kind in component.kinds
                for name, number in numbers_of(component, KINDS[kind]).items()
            },
            "document": component.place,
            "doubts": list(map(str, component.doubts)),
        }
        for component in matches[:LIST_ROWS]
    ]
    return {"count": len(matches), "components": rows}
