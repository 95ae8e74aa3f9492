// Lays the letters of figures out in a browser, and reports what leaves its picture, lies over another text or over a line.
// node figures.cjs FOLDER [NAME…]: SVG files, those whose names begin so.
const fs = require('fs');
const path = require('path');
const { chromium } = require('playwright-core');

const folder = path.resolve(process.argv[2]);
const names = process.argv.slice(3);
const assets = path.resolve(__dirname, '../book/src/assets');
const files = fs.readdirSync(folder).filter((file) => file.endsWith('.svg'))
    .filter((file) => names.length === 0 || names.some((name) => file === `${name}.svg` || file.startsWith(`${name}--`))).sort();

// Runs in the page. A text is its box, less the air above and below its letters.
function faults() {
    const svg = document.querySelector('svg');
    const { width, height } = svg.viewBox.baseVal;
    const still = (element) => !element.closest('g, defs');
    const texts = [...svg.querySelectorAll('text')].filter((text) => still(text) && text.textContent.trim()).map((text) => {
        const box = text.getBBox();
        const size = parseFloat(text.getAttribute('font-size'));
        return { name: text.textContent, left: box.x, right: box.x + box.width, top: box.y + 0.28 * size, bottom: box.y + box.height - 0.3 * size };
    });
    const found = [];
    for (const [k, text] of texts.entries()) {
        if (text.left < 0 || text.right > width || text.top < 0 || text.bottom > height) found.push(`"${text.name}" leaves the picture`);
        for (const other of texts.slice(k + 1)) {
            const across = Math.min(text.right, other.right) - Math.max(text.left, other.left);
            const along = Math.min(text.bottom, other.bottom) - Math.max(text.top, other.top);
            if (across > 10 && along > 10) found.push(`"${text.name}" lies over "${other.name}"`);
        }
    }
    // Lines that are meant to be read: hairlines and faint ones go below a text without harm.
    const lines = [...svg.querySelectorAll('polyline, line')].filter(still).filter((line) => {
        const strength = parseFloat(line.getAttribute('opacity') ?? '1');
        return strength >= 0.4 && parseFloat(line.getAttribute('stroke-width') ?? '10') >= 7;
    });
    for (const text of texts) {
        const [left, right, top, bottom] = [text.left + 15, text.right - 15, text.top + 15, text.bottom - 15];
        const crossed = lines.some((line) => {
            const points = line.tagName === 'line'
                ? [[line.x1.baseVal.value, line.y1.baseVal.value], [line.x2.baseVal.value, line.y2.baseVal.value]]
                : [...line.points].map((point) => [point.x, point.y]);
            return points.slice(1).some(([x1, y1], k) => {
                const [x0, y0] = points[k];
                // The piece of the segment inside the box (Liang and Barsky).
                let [from, to] = [0, 1];
                for (const [step, room] of [[x0 - x1, x0 - left], [x1 - x0, right - x0], [y0 - y1, y0 - top], [y1 - y0, bottom - y0]]) {
                    if (step === 0 && room < 0) return false;
                    if (step < 0) from = Math.max(from, room / step);
                    if (step > 0) to = Math.min(to, room / step);
                }
                return from < to;
            });
        });
        if (crossed) found.push(`"${text.name}" lies over a line`);
    }
    return found;
}

(async () => {
    const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
    const page = await browser.newPage({ viewport: { width: 640, height: 700 } });
    const sheet = (name) => `<link rel="stylesheet" href="file://${assets}/${name}">`;
    const frame = path.join(folder, '.frame.html');
    let wrong = 0;
    for (const file of files) {
        const svg = fs.readFileSync(path.join(folder, file), 'utf8');
        const roman = '<style>svg { --roman: "Spinning Roman", KaTeX_Main, KaTeX_Math; } svg, svg tspan { font-family: var(--roman) !important; } '
            + 'svg tspan[font-style] { font-family: KaTeX_Math, "Spinning Roman" !important; }</style>';
        fs.writeFileSync(frame, `<!DOCTYPE html><html><head><meta charset="utf-8">${sheet('katex/katex.min.css')}${sheet('book.css')}</head><body><div id="mdbook-content"><main>${svg}${roman}</main></div></body></html>`);
        await page.goto(`file://${frame}`);
        await page.evaluate(() => document.fonts.ready);
        for (const fault of await page.evaluate(faults)) {
            console.log(`${file}: ${fault}`);
            wrong += 1;
        }
    }
    fs.rmSync(frame, { force: true });
    await browser.close();
    console.log(`${files.length} figures looked at, ${wrong} faults`);
    process.exit(wrong === 0 ? 0 : 1);
})();
