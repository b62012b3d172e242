// The row of pictures: one for each arithmetic, and others beside them.

// Makes a new row and returns {root, canvas, note} for each title.
export function makePanels(row, titles) {
  row.replaceChildren();
  return titles.map(({key, title, about}) => {
    const root = document.createElement('figure');
    root.className = 'panel';
    root.dataset.key = key;
    const caption = document.createElement('figcaption');
    const name = document.createElement('strong');
    name.textContent = title;
    name.title = about;
    const note = document.createElement('span');
    note.className = 'note';
    caption.append(name, note);
    const canvas = document.createElement('canvas');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `${title}: ${about}`);
    root.append(caption, canvas);
    row.append(root);
    return {key, root, canvas, note};
  });
}

export function say(note, text, kind = '') {
  note.textContent = text;
  note.className = `note ${kind}`;
}

// An element with text or children.
export function element(name, content, className = '') {
  const e = document.createElement(name);
  e.className = className;
  e.append(...(Array.isArray(content) ? content : [content]));
  return e;
}
