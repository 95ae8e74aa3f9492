// What mdBook's script leaves undone. Every page can be read without it.
'use strict';

// Copy gives a program: the hidden lines as well, in the `main` that the test runner writes round them.
window.playground_text = (block) => {
    const code = block.querySelector('code');
    const text = code.textContent;
    if (!code.classList.contains('language-rust') || /\bfn main\s*\(/.test(text)) return text;
    const failure = /\bOk::<\(\), (.+)>\(\(\)\)\s*$/.exec(text);
    return `fn main()${failure ? ` -> Result<(), ${failure[1]}>` : ''} {\n${text.trimEnd()}\n}\n`;
};
for (const button of document.querySelectorAll('main pre .clip-button')) {
    if (button.closest('pre').querySelector('code.language-rust')) {
        button.title = 'Copy the whole program, hidden lines included';
        button.setAttribute('aria-label', button.title);
    }
}

// What scrolls sideways can be reached with the keyboard. First all is measured, then all is changed: to alternate would lay the page out
// each time.
function reachable() {
    const names = { CODE: 'Code', SPAN: 'Formula', DIV: 'Table' };
    const boxes = [...document.querySelectorAll('main pre > code, main .katex-display, main .table-wrapper')];
    const scrolls = boxes.map((box) => box.scrollWidth > box.clientWidth);
    boxes.forEach((box, i) => {
        if (scrolls[i] === (box.getAttribute('role') === 'region')) return;
        const marks = { tabindex: '0', role: 'region', 'aria-label': `${names[box.tagName]}, scrolls sideways` };
        for (const [key, value] of Object.entries(marks)) {
            if (scrolls[i]) box.setAttribute(key, value);
            else box.removeAttribute(key);
        }
    });
}
document.fonts.ready.then(reachable);
addEventListener('resize', reachable);
addEventListener('toggle', reachable, true);

// Answers that are folded on the screen stand open on paper.
let opened = [];
addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll('details:not([open])')];
    for (const details of opened) details.open = true;
});
addEventListener('afterprint', () => {
    for (const details of opened) details.open = false;
});

// The arrows say where they lead.
for (const arrow of document.querySelectorAll('.nav-chapters, .mobile-nav-chapters')) {
    const entry = document.querySelector(`#mdbook-sidebar a[href$="${arrow.getAttribute('href')}"]`);
    if (entry) {
        arrow.title += `: ${entry.textContent.trim()}`;
        arrow.setAttribute('aria-label', arrow.title);
    }
}
