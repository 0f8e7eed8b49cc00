"""Tasks that the editor runs in processes of their own: reports, studies, fits and exports."""
