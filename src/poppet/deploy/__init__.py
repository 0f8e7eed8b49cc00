"""A circuit in other places: as C, in simulation tools, on a PLC, in a browser; one trace for all of them."""

from poppet.deploy.carried import Carried, CarriedInput, CarriedNumber, Quantity, carried

__all__ = ["Carried", "CarriedInput", "CarriedNumber", "Quantity", "carried"]
