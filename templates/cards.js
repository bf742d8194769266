"use strict";
// One tab stop for each card, for each table of errata and for each table of many links: the reader who uses the keyboard goes from one to the next,
// Enter leads to what is in it, and Escape back. Without script, or by mouse, all of it works as ever.
// What scrolls stays a stop, since nothing else could scroll it.
{
  const FOCUSABLE = "a[href], button, summary, input, select, textarea, .paper";
  const OUT = "data-stop"; // what was a stop and is none as long as its card is not entered
  const MANY = 8;
  for (const box of document.querySelectorAll(".table-box:not(article.claim *)")) {
    const links = box.querySelectorAll("a[href]").length;
    box.classList.toggle("stop", links > MANY || (links > 0 && box.closest(".errata-sheet") !== null));
  }
  const CARDS = "article.claim, .table-box.stop";
  const cardOf = (element) => element.closest(CARDS);
  const leave = (card) => {
    card.classList.remove("entered");
    for (const element of card.querySelectorAll(FOCUSABLE)) {
      if (element.tabIndex < 0 || (element.matches(".paper") && element.scrollWidth > element.clientWidth)) continue;
      element.setAttribute(OUT, "");
      element.tabIndex = -1;
    }
  };
  const enter = (card) => {
    if (card.classList.contains("entered")) return;
    for (const other of document.querySelectorAll(".entered")) leave(other);
    card.classList.add("entered");
    for (const element of card.querySelectorAll(`[${OUT}]`)) {
      element.tabIndex = 0;
      element.removeAttribute(OUT);
    }
  };

  for (const card of document.querySelectorAll(CARDS)) {
    const heading = card.querySelector("h3, h4");
    if (heading) {
      heading.id ||= `title-of-${card.id}`;
      card.setAttribute("aria-labelledby", heading.id);
    }
    for (const box of card.querySelectorAll(".table-box")) box.removeAttribute("tabindex"); // until it is seen to scroll
    card.tabIndex = 0;
    card.setAttribute("aria-keyshortcuts", "Enter");
    leave(card);
    card.addEventListener("focusin", ({ target }) => { if (target !== card) enter(card); });
    card.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && event.target === card) {
        enter(card);
        card.querySelector(FOCUSABLE)?.focus();
      } else if (event.key === "Escape" && event.target !== card) {
        card.focus();
        leave(card);
      } else return;
      event.preventDefault();
    });
  }

  // Who follows a link to a card wants what is in it.
  const arrive = () => {
    const target = document.getElementById(location.hash.slice(1));
    const card = target && cardOf(target);
    if (card) enter(card);
  };
  addEventListener("hashchange", arrive);
  arrive();
}
