// Opens every page of the built book (or those named after the folder) from disk, in a browser without a network, and reports what a reader would mind.
const fs = require('fs');
const http = require('http');
const path = require('path');
const { chromium } = require('playwright-core');

const folder = path.resolve(process.argv[2] || 'book/build');
// Characters of code that fit at 1200 px, in the column and under a fold; the test `no_line_of_code_is_wider_than_the_column` holds the lines to it.
const COLUMN = 97;
const FOLDED = 87;
const url = (page) => 'file://' + path.join(folder, page);
const pages = fs.readdirSync(folder).filter((name) => name.endsWith('.html') && name !== 'toc.html')
    .filter((name) => process.argv.length < 4 || process.argv.includes(name)).sort();
let passed = 0;
const faults = [];

function check(what, found) {
    if (found.length === 0) passed += 1;
    else faults.push(...found.map((fault) => `${what}: ${fault}`));
}

async function inBrowser(browser, theme, width, work) {
    const context = await browser.newContext({ viewport: { width, height: 900 } });
    await context.addInitScript((theme) => {
        try { localStorage.setItem('mdbook-theme', theme); } catch (e) { /* a page without storage */ }
        window.print = () => {};
    }, theme);
    const page = await context.newPage();
    page.setDefaultTimeout(180000); // the print page holds the whole book
    const heard = [];
    page.on('console', (message) => {
        if (message.type() === 'error') heard.push(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => heard.push(`script: ${error.message}`));
    page.on('request', (request) => {
        if (!/^(file|data|blob|http:\/\/127\.0\.0\.1):/.test(request.url())) heard.push(`request to ${request.url()}`);
    });
    page.on('requestfailed', (request) => {
        const why = request.failure()?.errorText;
        // A page that is left takes back what it still asks for (its icon, most often): nothing is missing then.
        if (why !== 'net::ERR_ABORTED') heard.push(`not loaded (${why}): ${request.url()}`);
    });
    await work(page, heard);
    await context.close();
}

// What is wrong with the page as it stands.
function look(theme) {
    const faults = [];
    const policy = document.querySelector('meta[http-equiv="Content-Security-Policy"]');
    if (!policy || /https?:|\*/.test(policy.content)) faults.push('no policy that forbids every other host');
    if (!document.documentElement.classList.contains(theme)) faults.push(`the theme is not ${theme}`);
    for (const figure of document.querySelectorAll('main figure')) {
        const picture = figure.querySelector('svg');
        const box = picture && picture.getBoundingClientRect();
        if (!box || box.width < 100 || box.height < 50) faults.push(`#${figure.id} is not to be seen`);
        else if (getComputedStyle(picture).visibility !== 'visible') faults.push(`#${figure.id} is hidden`);
    }
    for (const error of document.querySelectorAll('.katex-error, [data-piece]')) {
        faults.push(`a formula is not set: ${error.textContent.slice(0, 60)}`);
    }
    for (const formula of document.querySelectorAll('main .katex-html')) {
        const box = formula.getBoundingClientRect();
        const folded = formula.closest('details:not([open])');
        if (!folded && box.width === 0) faults.push(`an empty formula: ${formula.textContent.slice(0, 60)}`);
    }
    const family = getComputedStyle(document.querySelector('main')).fontFamily;
    if (!family.includes('Spinning Roman')) faults.push(`the text is set in ${family}`);
    return faults;
}

// Each of these sticks out of a page that must not scroll sideways.
function wide() {
    const limit = document.documentElement.clientWidth;
    const widest = document.documentElement.scrollWidth;
    if (widest <= limit) return [];
    const culprits = [...document.querySelectorAll('main *')]
        .filter((e) => e.getBoundingClientRect().right > limit + 1)
        .slice(0, 3)
        .map((e) => `${e.tagName.toLowerCase()}.${e.className.baseVal ?? e.className}`);
    return [`${widest} px wide in a window of ${limit} (${culprits.join(', ')})`];
}

// The body and the page in it clip what sticks out, so the text column is measured as well.
function clipped() {
    const limit = Math.min(document.documentElement.clientWidth, document.querySelector('#mdbook-content').getBoundingClientRect().right);
    return [...document.querySelectorAll('main > *, main figure > *, main div > p, main .katex-base')]
        .filter((e) => !e.closest('.katex-display, .table-wrapper') && e.getClientRects().length > 0 && e.getBoundingClientRect().right > limit + 1)
        .slice(0, 3)
        .map((e) => `${e.tagName.toLowerCase()} reaches ${Math.round(e.getBoundingClientRect().right)} px: ${e.textContent.slice(0, 40)}`);
}

// Room for code, in characters, where it is less than promised.
function narrow([column, folded]) {
    return [...document.querySelectorAll('main > pre > code, main details pre > code')].map((code) => {
        const ruler = code.appendChild(document.createElement('span'));
        ruler.textContent = '0'.repeat(100);
        ruler.style.whiteSpace = 'pre';
        const width = ruler.getBoundingClientRect().width / 100;
        ruler.remove();
        const style = getComputedStyle(code);
        const room = code.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
        const promised = code.closest('details') ? folded : column;
        return room / width < promised ? `${(room / width).toFixed(1)} characters fit, ${promised} are promised` : '';
    }).filter(Boolean);
}

// What scrolls, and no key reaches it.
function beyondKeys() {
    return [...document.querySelectorAll('main pre > code, main .katex-display, main .table-wrapper')]
        .filter((e) => e.scrollWidth > e.clientWidth && (e.tabIndex < 0 || !e.getAttribute('aria-label')))
        .map((e) => `no key scrolls: ${e.textContent.slice(0, 40)}`);
}

// Contrast of the page's own entry in the table of contents, and of code.
function faint() {
    const light = (color) => {
        const whole = color.startsWith('color(') ? 1 : 255;
        const [r, g, b] = color.match(/[\d.]+/g).slice(0, 3).map((c) => c / whole)
            .map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const ground = (element) => {
        const color = getComputedStyle(element).backgroundColor;
        return color === 'rgba(0, 0, 0, 0)' && element.parentElement ? ground(element.parentElement) : color;
    };
    return [...document.querySelectorAll('#mdbook-sidebar a.active, main code')].map((element) => {
        const [a, b] = [getComputedStyle(element).color, ground(element)].map(light).sort((x, y) => y - x);
        const contrast = (a + 0.05) / (b + 0.05);
        return contrast < 4.5 ? `"${element.textContent.slice(0, 40)}" stands out by ${contrast.toFixed(1)} : 1 only` : '';
    }).filter(Boolean);
}

// What the button of the first example with a hidden line copies must be a program, hidden lines included.
async function copies(page) {
    return page.evaluate(() => {
        const code = [...document.querySelectorAll('main pre > code.language-rust')].find((c) => c.querySelector('.boring'));
        const button = code.closest('pre').querySelector('.clip-button');
        let copied = '';
        document.addEventListener('copy', () => { copied = document.activeElement.value; }, { once: true });
        button.click();
        const hidden = code.querySelector('.boring').textContent.trim();
        const program = copied.includes(hidden) && /^fn main\(\)/.test(copied) && copied.trimEnd().endsWith('}');
        return program && /hidden/.test(button.title) ? [] : [`no program: ${copied.slice(0, 80)}`];
    });
}

async function searches(page, address, word) {
    await page.goto(`${address}?search=${word}`);
    const hits = '#mdbook-searchresults li';
    return page.waitForSelector(hits, { timeout: 20000 }).then(() => page.locator(hits).count(), () => 0);
}

// Runs in the page: moves every slider of every live figure to both of its ends, and back again.
async function toBothEnds() {
    const faults = [];
    const until = async (done) => {
        for (let k = 0; k < 1500 && !done(); k += 1) await new Promise((resolve) => setTimeout(resolve, 10));
        return done();
    };
    for (const figure of document.querySelectorAll('main figure[data-live]')) {
        const picture = () => figure.querySelector('svg.fig');
        const [printed, words] = [picture().outerHTML, figure.querySelector('figcaption').outerHTML];
        for (const slider of figure.querySelectorAll('input[type=range]')) {
            for (const end of [slider.min, slider.max]) {
                if (Math.abs(slider.value - end) < 1e-9) continue; // the book's own
                const before = picture();
                const fault = (told) => faults.push(`#${figure.id}, ${slider.name} at ${end}: ${told}`);
                slider.value = end;
                slider.dispatchEvent(new Event('input', { bubbles: true }));
                const refusal = figure.querySelector('.live-refusal');
                if (!await until(() => picture() !== before || !refusal.hidden)) fault('nothing is drawn');
                if (!refusal.hidden) fault(refusal.textContent);
                if (figure.querySelectorAll('svg.fig').length !== 1) fault('not one picture');
                const said = [...figure.querySelectorAll('figcaption .formula, .live')].map((one) => one.textContent).join(' ');
                if (/[\\${}]/.test(said)) fault(`no formula: ${said}`);
                if (slider.getBoundingClientRect().height < 24) fault('too low for a finger');
                if (/10[⁻⁰-⁹]/.test(slider.getAttribute('aria-valuetext'))) fault('a power is not told in words');
                figure.querySelector('.live button').click();
                if (picture().outerHTML !== printed || figure.querySelector('figcaption').outerHTML !== words) fault('the printed figure does not come back');
            }
        }
    }
    return faults;
}

// A live figure under the hand: by a slider, a key, a point that is dragged, and an address.
async function underTheHand(page) {
    const faults = [];
    const is = (what, right) => { if (!right) faults.push(what); };
    const figure = page.locator('#fig-billiard');
    const slider = figure.locator('input[name=cue]');
    const state = () => figure.evaluate((f) => ({ picture: f.querySelector('svg.fig').outerHTML, words: f.querySelector('figcaption').textContent, hash: location.hash, cue: Number(f.querySelector('[name=cue]').value) }));
    await page.goto(url('rolling.html'));
    const printed = await state();
    const other = (than) => page.waitForFunction((than) => document.querySelector('#fig-billiard svg.fig').outerHTML !== than, than.picture);
    await slider.evaluate((s) => { s.value = 0.73; s.dispatchEvent(new Event('input', { bubbles: true })); });
    await other(printed);
    const moved = await state();
    is(`the caption does not follow: ${moved.words}`, moved.words !== printed.words && moved.words.includes('0.73'));
    is(`the address does not follow: ${moved.hash}`, moved.hash === '#fig-billiard?cue=0.73&kappa=0.4');
    await slider.focus();
    await page.keyboard.press('End');
    await other(moved);
    is('End is not the greatest value', (await state()).cue === 1.9);
    await page.keyboard.press('ArrowLeft');
    is('a key does not rest on a round value', (await state()).cue === 1.89);
    await figure.locator('.live button').click();
    const back = await state();
    is('the printed figure does not come back', back.picture === printed.picture && back.words === printed.words && back.hash === '' && back.cue === 1.2);
    const knob = figure.locator('.live-handle');
    await knob.scrollIntoViewIfNeeded();
    const box = await knob.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 - 30, { steps: 5 });
    await other(back);
    await page.mouse.up();
    is('a point that is dragged does not move its number', (await state()).cue > 1.3);
    await page.goto('about:blank');
    await page.goto(url('rolling.html#fig-billiard?cue=0.5&kappa=0.6'));
    await other(printed);
    is('an address is not followed', (await state()).cue === 0.5);
    is('the figure of the address is not to be seen', await figure.evaluate((f) => { const { top, bottom } = f.getBoundingClientRect(); return bottom > 0 && top < innerHeight; }));
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    is('on paper stands another figure', (await state()).picture === printed.picture);
    return faults;
}

// The built book behind a server of this machine, as a reader on the network has it.
function served() {
    const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml', '.woff2': 'font/woff2' };
    const server = http.createServer((request, response) => {
        const file = path.join(folder, path.normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname)));
        fs.readFile(file, (error, bytes) => {
            response.writeHead(error ? 404 : 200, { 'content-type': types[path.extname(file)] || 'application/octet-stream' });
            response.end(bytes);
        });
    });
    return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

(async () => {
    const browser = await chromium.launch({
        executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
        args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking', '--no-first-run',
            '--disable-component-update', '--disable-sync', '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1'],
    });

    for (const theme of ['light', 'navy']) {
        await inBrowser(browser, theme, 1280, async (page, heard) => {
            for (const name of pages) {
                heard.length = 0;
                await page.goto(url(name));
                await page.evaluate(() => document.fonts.ready);
                const fonts = await page.evaluate(() =>
                    [...document.fonts].filter((f) => f.status === 'error').map((f) => `font ${f.family} is not loaded`));
                check(`${name} in ${theme}`, [...heard, ...fonts, ...await page.evaluate(look, theme)]);
            }
        });
    }

    await inBrowser(browser, 'light', 360, async (page) => {
        for (const name of pages) {
            await page.goto(url(name));
            await page.evaluate(() => document.querySelectorAll('details').forEach((d) => { d.open = true; }));
            await page.evaluate(() => document.fonts.ready);
            check(`${name} at 360 px`, [...await page.evaluate(wide), ...await page.evaluate(clipped), ...await page.evaluate(beyondKeys)]);
        }
    });

    for (const theme of ['rust', 'coal', 'ayu']) {
        const name = pages.includes('inertia.html') ? 'inertia.html' : pages[0];
        await inBrowser(browser, theme, 360, async (page, heard) => {
            await page.goto(url(name));
            await page.evaluate(() => document.fonts.ready);
            check(`${name} in ${theme} at 360 px`, [...heard, ...await page.evaluate(look, theme), ...await page.evaluate(wide)]);
        });
    }

    await inBrowser(browser, 'light', 1200, async (page) => {
        for (const name of pages) {
            await page.goto(url(name));
            await page.evaluate(() => document.querySelectorAll('details').forEach((d) => { d.open = true; }));
            await page.evaluate(() => document.fonts.ready);
            check(`${name} at 1200 px`, await page.evaluate(narrow, [COLUMN, FOLDED]));
        }
    });

    for (const theme of ['light', 'rust', 'coal', 'navy', 'ayu']) {
        await inBrowser(browser, theme, 1280, async (page) => {
            await page.goto(url('rolling.html'));
            check(`contrast in ${theme}`, await page.evaluate(faint));
        });
    }

    const server = await served();
    for (const home of [url(''), `http://127.0.0.1:${server.address().port}`]) {
        await inBrowser(browser, 'light', 1280, async (page, heard) => {
            for (const word of ['inertia', 'polhode', 'superball']) {
                heard.length = 0;
                const found = await searches(page, `${home}/index.html`, word);
                check(`search for "${word}" from ${home}`, found > 0 ? heard : ['no hit', ...heard]);
            }
            await page.click('#mdbook-theme-toggle');
            await page.click('#mdbook-theme-coal');
            const coal = await page.evaluate(() => document.documentElement.classList.contains('coal'));
            check(`another theme from ${home}`, coal ? heard : ['the theme does not change', ...heard]);
        });
    }
    server.close();

    await inBrowser(browser, 'light', 1280, async (page, heard) => {
        await page.goto(url('superball.html'));
        check('copy', [...await copies(page), ...heard]);
        await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
        const folded = await page.locator('details:not([open])').count();
        check('folds on paper', folded === 0 ? [] : [`${folded} stay shut`]);
        await page.evaluate(() => dispatchEvent(new Event('afterprint')));
        check('folds after printing', await page.locator('details[open]').count() === 0 ? [] : ['they stay open']);

        await page.goto(url('lagrange-top.html'));
        await page.locator('.pause input').first().focus();
        await page.keyboard.press('Space');
        const moving = await page.evaluate(() => {
            const all = document.querySelector('figure:has(.pause) svg').getAnimations({ subtree: true });
            return all.length > 0 ? all.filter((one) => one.playState === 'running').length : -1;
        });
        check('a moving figure is held by a key', moving === 0 ? [] : [`${moving} of its parts move`]);
    });

    for (const [theme, width] of [['light', 1280], ['navy', 1280], ['light', 390]]) {
        await inBrowser(browser, theme, width, async (page, heard) => {
            check(`a live figure in ${theme} at ${width} px`, [...await underTheHand(page), ...heard, ...await page.evaluate(wide)]);
        });
    }
    await inBrowser(browser, 'light', 390, async (page, heard) => {
        for (const name of pages.filter((name) => name !== 'print.html')) {
            heard.length = 0;
            await page.goto(url(name));
            check(`live figures of ${name}`, [...await page.evaluate(toBothEnds), ...heard, ...await page.evaluate(wide), ...await page.evaluate(clipped)]);
        }
    });

    await browser.close();
    for (const fault of faults) console.log(`   ${fault}`);
    console.log(`   ${pages.length} pages: ${passed} passed, ${faults.length} failed`);
    process.exit(faults.length === 0 ? 0 : 1);
})().catch((error) => {
    console.log(`   the browser check broke off: ${error.message}`);
    process.exit(1);
});
