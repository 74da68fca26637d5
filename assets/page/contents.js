// The list of contents: where the reader is in it, and the way to the previous and the next figure.
"use strict";

const makeContents = (() => {
  const kNear = 24;  // How far below the place that a link leads to a figure still counts as the one that is looked at. [pixels]

  return function makeContents(nav, figures) {
    const list = nav.querySelector("details");
    const links = new Map([...nav.querySelectorAll("a")].map((link) => [decodeURIComponent(link.hash.slice(1)), link]));
    const isWide = matchMedia("(min-width: 84rem)");
    /** Those that aren't folded away, which have no place. */
    const shown = () => figures.filter((figure) => !figure.closest(".folded:not([open])"));

    /** Where a figure is, from its place in the window if a link leads to it: at the sentence before it. [pixels] */
    const placeOf = (figure) => figure.getBoundingClientRect().top - parseFloat(getComputedStyle(figure).scrollMarginTop);

    /** The figure that is looked at: the last whose top is above the middle of the window; undefined above the first. */
    function current() {
      return shown().findLast((figure) => figure.getBoundingClientRect().top < innerHeight / 2);
    }

    function mark() {
      const id = current()?.id;
      const link = links.get(id);
      if (link?.hasAttribute("aria-current")) return;
      for (const each of links.values()) each.removeAttribute("aria-current");
      link?.setAttribute("aria-current", "true");
      if (!link || !isWide.matches) return;
      // In the list alone: scrollIntoView() would move the page, too.
      const {top, bottom} = link.getBoundingClientRect();
      if (top < 0 || bottom > innerHeight) nav.scrollTop += top - innerHeight / 2;
    }

    function go(figure) {
      if (!figure) return;
      history.replaceState(null, "", "#" + encodeURIComponent(figure.id));
      figure.scrollIntoView();
      figure.setAttribute("tabindex", "-1");
      figure.focus({preventScroll: true});
    }

    function next() {
      go(shown().find((figure) => placeOf(figure) > kNear));
    }
    function previous() {
      go(shown().findLast((figure) => placeOf(figure) < -kNear));
    }

    for (const [name, act] of [["previous", previous], ["next", next]]) {
      const button = nav.querySelector("." + name);
      button.hidden = false;
      button.addEventListener("click", act);
    }
    const fold = () => { list.open = isWide.matches; };
    isWide.addEventListener("change", fold);
    fold();
    // Where the list covers the page, it opens at the reader's place.
    list.addEventListener("toggle", () => {
      const link = list.querySelector("[aria-current]");
      if (link && list.open && !isWide.matches) link.scrollIntoView({block: "center"});
    });
    nav.addEventListener("click", (event) => { if (event.target.closest("a") && !isWide.matches) list.open = false; });
    nav.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || isWide.matches || !list.open) return;
      list.open = false;
      list.querySelector("summary").focus();
    });
    addEventListener("scroll", mark, {passive: true});
    mark();
    return {previous, next};
  };
})();
