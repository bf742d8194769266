"""The report on a design: what ``trimmer.design`` computed, as pages."""
