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

// What scrolls sideways can be reached with the keyboard.
function reachable() {
    const boxes = { 'main pre > code': 'Code', 'main .katex-display': 'Formula', 'main .table-wrapper': 'Table' };
    for (const [boxed, name] of Object.entries(boxes)) {
        for (const box of document.querySelectorAll(boxed)) {
            if (box.scrollWidth > box.clientWidth) {
                box.tabIndex = 0;
                box.setAttribute('role', 'region');
                box.setAttribute('aria-label', `${name}, scrolls sideways`);
            } else if (box.getAttribute('role') === 'region') {
                for (const key of ['tabindex', 'role', 'aria-label']) box.removeAttribute(key);
            }
        }
    }
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
