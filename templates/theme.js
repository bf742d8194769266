// Before the first paint; a browser may forbid a file to remember anything.
try {
  const theme = localStorage.getItem("trimmer-report-theme");
  if (theme) document.documentElement.dataset.theme = theme;
} catch { }
