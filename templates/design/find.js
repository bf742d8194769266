"use strict";
// Search in the report; the words are in the address, so that a link keeps them.
{
  const MOST_RESULTS = 40;
  document.querySelector(".sidebar").prepend(document.getElementById("search-tools").content.cloneNode(true));
  const tools = document.querySelector("search.tools");
  const form = tools.querySelector("form");
  const { query } = form.elements;
  const state = form.querySelector("output");
  const reset = form.querySelector("button[type=reset]");
  const results = tools.querySelector(".results");
  const hint = tools.querySelector(".hint");

  const found = (terms) => {
    const ranks = new Map();
    for (const entry of terms.length > 0 ? search.entries() : []) {
      const rank = search.rank(entry, terms);
      if (rank !== undefined) ranks.set(entry, rank);
    }
    return [...ranks.keys()].sort((one, other) => ranks.get(one) - ranks.get(other));
  };
  const item = ({ id, heading, place }) => {
    const line = document.createElement("li");
    const link = Object.assign(document.createElement("a"), { href: `#${id}`, textContent: heading });
    line.append(link, Object.assign(document.createElement("span"), { className: "place", textContent: place ?? "section" }));
    return line;
  };
  const show = () => {
    const terms = search.terms(query.value);
    const places = found(terms);
    results.replaceChildren(...places.slice(0, MOST_RESULTS).map(item));
    results.hidden = places.length === 0;
    reset.hidden = terms.length === 0;
    state.textContent = terms.length > 0 ? `${places.length} place${places.length === 1 ? "" : "s"}` : "";
    hint.hidden = terms.length === 0 || places.length > 0;
    hint.textContent = hint.hidden ? "" : `Nothing has “${query.value.trim()}”. Fewer words find more.`;
    search.mark(places, terms);
  };
  const remember = () => {
    const text = query.value.trim() ? `?${new URLSearchParams({ query: query.value.trim() })}` : "";
    history.replaceState(null, "", `${location.pathname}${text}${location.hash}`);
  };

  form.addEventListener("input", () => { show(); remember(); });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    results.querySelector("a")?.click();
  });
  form.addEventListener("reset", () => setTimeout(() => { show(); remember(); }));
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && !event.target.closest("input, select, textarea")) {
      event.preventDefault();
      query.focus();
    }
  });
  query.value = new URLSearchParams(location.search).get("query") ?? "";
  show();
}
