// Opens every page of the built book from disk, in a browser without a network, and reports what a reader would mind.
const fs = require('fs');
const path = require('path');
const { chromium } = require('playwright-core');

const folder = path.resolve(process.argv[2] || 'book/build');
const url = (page) => 'file://' + path.join(folder, page);
const pages = fs.readdirSync(folder).filter((name) => name.endsWith('.html') && name !== 'toc.html').sort();
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
    const heard = [];
    page.on('console', (message) => {
        if (message.type() === 'error') heard.push(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => heard.push(`script: ${error.message}`));
    page.on('request', (request) => {
        if (!/^(file|data|blob):/.test(request.url())) heard.push(`request to ${request.url()}`);
    });
    page.on('requestfailed', (request) => heard.push(`not loaded: ${request.url()}`));
    await work(page, heard);
    await context.close();
}

// What is wrong with the page as it stands.
function look(theme) {
    const faults = [];
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

// The body clips what sticks out, so the text column is measured as well.
function clipped() {
    const limit = document.documentElement.clientWidth;
    return [...document.querySelectorAll('main > *, main figure > *, main div > p, main .katex-base')]
        .filter((e) => !e.closest('.katex-display, .table-wrapper') && e.getClientRects().length > 0 && e.getBoundingClientRect().right > limit + 1)
        .slice(0, 3)
        .map((e) => `${e.tagName.toLowerCase()} reaches ${Math.round(e.getBoundingClientRect().right)} px: ${e.textContent.slice(0, 40)}`);
}

(async () => {
    const browser = await chromium.launch({
        executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
        args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking', '--no-first-run',
            '--disable-component-update', '--disable-sync', '--host-resolver-rules=MAP * ~NOTFOUND'],
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
            check(`${name} at 360 px`, [...await page.evaluate(wide), ...await page.evaluate(clipped)]);
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

    await inBrowser(browser, 'light', 1280, async (page, heard) => {
        await page.goto(url('index.html') + '?search=inertia');
        const hits = '#mdbook-searchresults li';
        const found = await page.waitForSelector(hits, { timeout: 20000 }).then(() => page.locator(hits).count(), () => 0);
        check('search for "inertia"', found > 0 ? heard : ['no hit', ...heard]);
    });

    await browser.close();
    for (const fault of faults) console.log(`   ${fault}`);
    console.log(`   ${pages.length} pages: ${passed} passed, ${faults.length} failed`);
    process.exit(faults.length === 0 ? 0 : 1);
})().catch((error) => {
    console.log(`   the browser check broke off: ${error.message}`);
    process.exit(1);
});
