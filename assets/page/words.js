// What scripts say, in the page's language. The page has its list of words as JSON; without one, English is said.
"use strict";

const say = (() => {
  let words = null;

  function read() {
    const {lang} = globalThis.document?.documentElement ?? {};
    const list = lang && document.querySelector(`script.words[lang="${lang}"]`);
    return list ? JSON.parse(list.textContent) : {};
  }

  /** Returns a text in the page's language by its English, with values in the places of their {names}. */
  function say(english, values = {}) {
    words ??= read();
    return (words[english] ?? english).replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place);
  }

  /** Returns the text of a number with the language's decimal mark. */
  say.number = (text) => {
    words ??= read();
    return String(text).replace(".", words.decimal_mark ?? ".");
  };

  const kSaid = [["[aria-label]", "aria-label"], ["[aria-roledescription]", "aria-roledescription"], ["[title]", "title"], ["meta[name=description]", "content"]];

  /** Puts what an element and those within it say into the page's language. */
  say.within = (root) => {
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const english = node.data.trim();
      if (say(english) !== english) node.data = node.data.replace(english, () => say(english));
    }
    for (const [selector, name] of kSaid) {
      for (const element of root.querySelectorAll(selector)) element.setAttribute(name, say(element.getAttribute(name)));
    }
  };
  return say;
})();
