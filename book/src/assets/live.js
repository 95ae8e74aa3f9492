// Figures under the hand: sliders below a picture, which is drawn again by the program that drew it for the book. Every page can be read without.
'use strict';
(() => {

// The module comes when a figure is first touched, and not before: it is as large as all pages together.
const home = document.currentScript.src;
let loading = null;
let pen = null;
async function load() {
    loading ??= new Promise((resolve, reject) => {
        const script = document.createElement('script');
        // A page from disk may not fetch. A script it may load, so the module comes as text in one.
        script.src = new URL('live-module.js', home);
        script.onerror = () => reject(new Error('the module is not there'));
        script.onload = () => {
            const text = atob(window.liveModule);
            delete window.liveModule;
            const bytes = new Uint8Array(text.length);
            for (let k = 0; k < text.length; k += 1) bytes[k] = text.charCodeAt(k);
            resolve(WebAssembly.compile(bytes));
        };
        document.head.append(script);
    });
    const module = await loading;
    pen ??= new WebAssembly.Instance(module).exports;
}

// A question to the module, and its answer in parts; live/src/lib.rs says which there are.
function ask(question) {
    const bytes = new TextEncoder().encode(question);
    const at = pen.room(bytes.length);
    new Uint8Array(pen.memory.buffer, at, bytes.length).set(bytes);
    const from = pen.draw();
    return new TextDecoder().decode(new Uint8Array(pen.memory.buffer, from, pen.length())).split('\0');
}

function element(tag, properties, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
}

// LaTeX of one line as letters, raised and lowered ones among them. What the press has set already is taken from the page instead.
const TIMES = '\u2009·\u2009';
const SIGNS = {
    alpha: 'α', gamma: 'γ', epsilon: 'ϵ', varepsilon: 'ε', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', rho: 'ρ', varphi: 'φ', Psi: 'Ψ', Omega: 'Ω', Delta: 'Δ',
    ell: 'ℓ', perp: '⊥', pm: '±', cdot: TIMES, lvert: '|', rvert: '|', cos: '\u2009cos\u2009', ln: '\u2009ln\u2009', ',': '\u2009',
};
function readable(latex) {
    const tokens = latex.match(/\\[A-Za-z]+|\\.|[0-9.]+|\S/gu) ?? [];
    let [upright, before] = [false, '='];
    const group = () => {
        if (tokens[0] !== '{') return next();
        tokens.shift();
        const parts = [];
        while (tokens.length > 0 && tokens[0] !== '}') parts.push(next());
        tokens.shift();
        return parts.join('');
    };
    const next = () => {
        const token = tokens.shift() ?? '';
        const first = /^[=<(,^_]$/.test(before);
        before = token;
        if (token === '{') { tokens.unshift(token); return group(); }
        if (token === '_') return `<sub>${group()}</sub>`;
        if (token === '^') return `<sup>${group()}</sup>`;
        if (token === '\\sqrt') return tokens[2] === '}' ? `√${group()}` : `√(${group()})`;
        if (/^\\[td]?frac$/.test(token)) {
            // \frac12 is one half.
            if (/^\d\d+$/.test(tokens[0])) tokens.splice(0, 1, ...tokens[0]);
            return `<sup>${group()}</sup>⁄<sub>${group()}</sub>`;
        }
        if (token === '\\text' || token === '\\mathrm') {
            upright = true;
            const words = group();
            upright = false;
            return words;
        }
        const sign = token[0] === '\\' ? SIGNS[token.slice(1)] ?? token : token;
        if (sign === ',') return ',\u2009';
        if (/^[-+±]$/.test(sign)) return `${first ? '' : '\u2009'}${sign.replace('-', '−')}${first ? '' : '\u2009'}`;
        if (/^[=<]$/.test(sign)) return ` ${sign.replace('<', '&lt;')} `;
        return /^[A-Za-zα-ωϵℓ]$/u.test(sign) && !upright ? `<i>${sign}</i>` : sign;
    };
    const parts = [];
    while (tokens.length > 0) parts.push(next());
    return parts.join('');
}

// A caption from plain text with formulas between dollars; `known` are those that are set. As on the printed page, no line ends before a unit, before the marks behind
// a formula, or within a short formula.
const MARKS = /^(?: (?:kg|cm|mm|rad|[mgsNJ])\b[^ .,;:!?)’]*)?[.,;:!?)’]*/;
function caption(text, known) {
    const bound = (words) => words.replaceAll('\'', '’').replace(/(\d|kg|N) (?=[^ ])/g, '$1\u00a0');
    const parts = text.split('$').map((part, k) => (k % 2 === 0 ? bound(part) : part));
    return parts.map((part, k) => {
        if (k % 2 === 0) return k > 0 ? part.replace(MARKS, '') : part;
        const [marks] = MARKS.exec(parts[k + 1] ?? '');
        const set = known?.get(part)?.cloneNode(true) ?? element('span', { className: part.length > 32 ? 'formula' : 'formula unbroken', innerHTML: readable(part) });
        return marks ? element('span', { className: 'unbroken' }, set, marks.replace(' ', '\u00a0')) : set;
    });
}

// A number with the digits that can be seen.
const raised = (digits) => digits.replaceAll('-', '⁻').replace(/\d/g, (digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]);
const aloud = (power) => ` to the power of ${power.replace('-', '−')}`;
function shown(value, raise = raised) {
    const round = Number(value.toPrecision(4));
    const text = round !== 0 && Math.abs(round) < 1e-4 ? round.toExponential() : String(round);
    const [digits, power] = text.replace(/^-/, '−').split('e');
    if (!power) return digits;
    return `${digits === '1' ? '' : `${digits}${TIMES}`}10${raise(power)}`;
}
const tidy = (value) => Number(value.toPrecision(12));

// Where a slider rests, round values: to 1, 2 or 5 in about a hundredth of the range; by equal ratios, to two digits.
function step({ least, greatest, scale }, value) {
    if (scale === 'whole') return 1;
    if (scale === 'logarithmic') return 10 ** (Math.floor(Math.log10(value) + 1e-9) - 1);
    const part = (greatest - least) / 100;
    const power = 10 ** Math.floor(Math.log10(part));
    return power * ([5, 2].find((digit) => digit * power <= part) ?? 1);
}

// A caption for the ear: a raised number is a power, and no digit of the number before it.
function spoken(...parts) {
    const words = element('p', {}, ...parts);
    for (const power of words.querySelectorAll('sup')) {
        const text = power.textContent;
        if (/\w/.test(text) && power.nextSibling?.textContent !== '⁄') power.textContent = { 2: ' squared', 3: ' cubed' }[text] ?? aloud(text);
    }
    return words.textContent.replaceAll(TIMES, ' times ');
}

// What is said aloud, a second after the hand rests.
const status = element('div', { className: 'live-spoken', role: 'status' });
let said = 0;
function say(words) {
    clearTimeout(said);
    said = setTimeout(() => { status.textContent = words; }, 1000);
}

// The address of what is seen. Browsers count how often it changes.
let written = { at: 0, timer: 0 };
function write(address) {
    clearTimeout(written.timer);
    const wait = written.at + 300 - performance.now();
    if (wait > 0) {
        written.timer = setTimeout(write, wait, address);
        return;
    }
    written.at = performance.now();
    try { history.replaceState(history.state, '', address); } catch (error) { /* a page that may not */ }
}

function live(figure) {
    const name = figure.id.slice('fig-'.length);
    const parameters = JSON.parse(figure.dataset.live);
    const words = figure.querySelector('figcaption');
    const printed = { picture: figure.querySelector('svg.fig'), words: [...words.childNodes] };
    const known = new Map([...words.querySelectorAll('annotation')].map((one) => [one.textContent, one.closest('.katex')]));
    const values = Object.fromEntries(parameters.map((one) => [one.key, one.default]));
    const moved = () => parameters.some((one) => values[one.key] !== one.default);
    const address = () => `${name}?${parameters.map(({ key }) => `${key}=${values[key]}`).join('&')}`;
    const dragged = parameters.filter((one) => one.place);
    let [picture, cost, frame, pause] = [printed.picture, 0, 0, 0];

    // A slider stands at its value, or at the logarithm of it (to base ten) where equal ways are equal ratios.
    const sliders = new Map(parameters.map((one) => {
        const place = (value) => (one.scale === 'logarithmic' ? Math.log10(value) : value);
        const input = element('input', { type: 'range', name: one.key, min: place(one.least), max: place(one.greatest), step: one.scale === 'whole' ? 1 : 'any' });
        const output = element('output', {});
        const at = () => (one.scale === 'logarithmic' ? tidy(10 ** input.value) : Number(input.value));
        return [one.key, { ...one, input, output, at, place }];
    }));

    // Holds a value to its range and shows it; the picture follows.
    function set(key, wanted) {
        const { input, output, place, least, greatest, scale, unit } = sliders.get(key);
        if (!Number.isFinite(wanted)) return;
        values[key] = Math.min(greatest, Math.max(least, scale === 'whole' ? Math.round(wanted) : wanted));
        input.value = place(values[key]);
        const one = (number) => (number === '1' ? unit.replace(/^turns/, 'turn') : unit);
        const measured = (number) => `${number}${unit && !unit.startsWith('°') ? ' ' : ''}${one(number)}`;
        output.textContent = measured(shown(values[key]));
        input.setAttribute('aria-valuetext', measured(shown(values[key], aloud).replace(TIMES, ' times ')));
    }
    // The same at a round value, unless that is beyond an end.
    function rest(key, wanted, grain = 1) {
        const { least, greatest } = sliders.get(key);
        if (!(wanted > least && wanted < greatest)) return set(key, wanted);
        const round = grain * step(sliders.get(key), wanted);
        return set(key, tidy(Math.round(wanted / round) * round));
    }

    // Another picture may be higher: the slider stays under the hand.
    function swap(fresh) {
        const { top } = controls.getBoundingClientRect();
        picture.replaceWith(fresh);
        picture = fresh;
        scrollBy({ top: controls.getBoundingClientRect().top - top, behavior: 'instant' });
    }

    function show(parts) {
        const [drawn, claim, details, places] = parts;
        refusal.hidden = parts.length > 1;
        if (parts.length === 1) {
            refusal.textContent = `There is no such picture: ${drawn}.`;
            return;
        }
        swap(element('template', { innerHTML: drawn }).content.firstElementChild);
        const number = words.querySelector('.figure-number');
        // A caption keeps the room that it needed once: what is below it stays where it is.
        words.setAttribute('style', `min-height: ${words.offsetHeight}px`);
        words.replaceChildren(number, ' ', element('strong', {}, ...caption(claim)), ' ', ...caption(details, known));
        for (const line of places.trim().split('\n')) {
            const [key, ...place] = line.split(' ');
            if (key) put(key, place.map(Number));
        }
        say(spoken(...caption(claim), ' ', ...caption(details)));
    }

    // The picture and the words of the book themselves, not a copy.
    function showPrinted() {
        refusal.hidden = true;
        if (picture === printed.picture) return;
        swap(printed.picture);
        words.replaceChildren(...printed.words);
        for (const { key, place } of dragged) put(key, place);
    }

    function draw() {
        frame = 0;
        if (!moved()) return showPrinted();
        if (!pen) return;
        const start = performance.now();
        try {
            show(ask(address()));
        } catch (error) {
            // A module that broke off is not asked again.
            pen = null;
            load().catch(() => {});
            refusal.hidden = false;
            refusal.textContent = 'There is no picture of these numbers.';
        }
        cost = performance.now() - start;
    }

    // One picture a frame; of one that takes long, when the hand rests.
    function redraw() {
        reset.hidden = !moved();
        write(`#fig-${address()}`);
        const soon = () => { frame ||= requestAnimationFrame(draw); };
        load().then(() => {
            clearTimeout(pause);
            if (cost > 100) pause = setTimeout(soon, 200);
            else soon();
        }, (error) => {
            refusal.hidden = false;
            refusal.textContent = `It cannot be moved here: ${error.message}.`;
        });
    }

    function restore() {
        for (const { key, default: value } of parameters) set(key, value);
        showPrinted();
        words.removeAttribute('style');
        reset.hidden = true;
        written.at = 0;
        write(location.href.split('#')[0]);
    }

    // Points of the picture that can be dragged, in a layer above it; two numbers may share one.
    const handles = new Map();
    const stage = element('div', { className: 'live-stage' });
    function put(key, [x, y]) {
        const { width, height } = picture.viewBox.baseVal;
        // The view box has ten units for each of the design.
        Object.assign(handles.get(key).style, { left: `${1000 * x / width}%`, top: `${1000 * y / height}%` });
        handles.get(key).place = [x, y];
    }
    function handle(keys) {
        const knob = element('span', { className: 'live-handle' });
        knob.setAttribute('aria-hidden', 'true');
        let grip = null;
        const point = (event) => {
            const box = picture.getBoundingClientRect();
            const units = picture.viewBox.baseVal.width / 10 / box.width;
            return [(event.clientX - box.left) * units, (event.clientY - box.top) * units];
        };
        knob.onpointerdown = (event) => {
            event.preventDefault();
            knob.setPointerCapture(event.pointerId);
            const [x, y] = point(event);
            grip = [knob.place[0] - x, knob.place[1] - y];
            load().catch(() => {});
        };
        knob.onpointermove = (event) => {
            if (!grip || !pen) return;
            const [x, y] = point(event);
            for (const key of keys) rest(key, Number(ask(`${address()}\n${key} ${x + grip[0]} ${y + grip[1]}`)[0]));
            redraw();
        };
        knob.onpointerup = knob.onpointercancel = () => { grip = null; };
        for (const key of keys) handles.set(key, knob);
        stage.append(knob);
    }

    const refusal = element('p', { className: 'live-refusal', role: 'alert', hidden: true });
    const reset = element('button', { type: 'button', textContent: 'As printed', hidden: true, onclick: restore });
    const labels = [...sliders.values()].map(({ key, symbol, meaning, input, output, at }) => {
        input.addEventListener('input', (event) => {
            // The hand rests on round values; whoever sets a number means that number.
            if (event.isTrusted) rest(key, at());
            else set(key, at());
            redraw();
        });
        input.addEventListener('keydown', (event) => {
            const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
            if (!way) return;
            event.preventDefault();
            const grain = event.shiftKey && sliders.get(key).scale !== 'whole' ? 0.1 : 1;
            rest(key, values[key] + way * grain * step(sliders.get(key), values[key]), grain);
            redraw();
        });
        const sign = element('span', { className: 'formula', innerHTML: readable(symbol) });
        return element('label', {}, element('span', {}, sign, `, ${meaning}`), output, input);
    });
    const head = element('p', {}, 'Move it yourself', reset);
    const controls = element('div', { className: 'live' }, head, element('div', {}, ...labels), refusal);
    controls.setAttribute('role', 'group');
    controls.setAttribute('aria-label', 'Numbers of this figure');
    words.before(controls);

    if (dragged.length > 0) {
        picture.replaceWith(stage);
        stage.append(picture);
        for (const place of new Set(dragged.map((one) => String(one.place)))) {
            handle(dragged.filter((one) => String(one.place) === place).map((one) => one.key));
        }
        for (const { key, place } of dragged) put(key, place);
    }
    for (const { key, default: value } of parameters) set(key, value);
    for (const approach of ['pointerenter', 'focusin']) figure.addEventListener(approach, () => load().catch(() => {}), { once: true });

    return {
        // What an address tells.
        open(pairs) {
            for (const [key, value] of pairs) if (sliders.has(key)) set(key, Number(value));
            redraw();
            figure.scrollIntoView();
        },
        printed: showPrinted,
        draw,
    };
}

const figures = new Map([...document.querySelectorAll('main figure[data-live]')].map((figure) => [figure.id, live(figure)]));
if (figures.size === 0) return;
document.body.append(status);
function follow() {
    const [, id, pairs] = /^#([^?]+)\?(.*)$/.exec(location.hash) ?? [];
    figures.get(id)?.open(new URLSearchParams(pairs));
}
addEventListener('hashchange', follow);
follow();
// On paper stands what the book says.
addEventListener('beforeprint', () => figures.forEach((figure) => figure.printed()));
addEventListener('afterprint', () => figures.forEach((figure) => figure.draw()));

})();
