"""A circuit in other places: as C, in simulation tools, on a PLC, in a browser; one trace for all of them."""

from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter, Quantity, build_export_model

__all__ = ["ExportInput", "ExportModel", "ExportParameter", "Quantity", "build_export_model"]
