"use strict";
// A link to a source file unfolds it; without script it leads to its name.
{
  const unfold = (hash) => {
    const place = document.getElementById(hash.slice(1));
    if (place?.matches("details.code")) place.open = true;
  };

  // A second click on the same link changes no address, so clicks count too.
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a.file");
    if (link) unfold(link.hash);
  });
  addEventListener("hashchange", () => unfold(location.hash));
  unfold(location.hash);
}
