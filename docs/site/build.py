#!/usr/bin/env python3
"""build.py OUT [--playground index.html] [--header graze.hpp]: writes the documentation as a site.

The pages are those of docs/, with the changelog and the like beside them, an index of all public names, and, if they are given,
the playground and the single header. Fails if mkdocs warns of anything, or if a link leads to an anchor that is not there.
"""
import argparse
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import names

ROOT = Path(__file__).resolve().parents[2]
PAGES = ('CHANGELOG.md', 'CONTRIBUTING.md', 'LICENSE')


class Links(HTMLParser):
    """Anchors and links of a page."""

    def __init__(self):
        super().__init__()
        self.anchors, self.links = set(), []

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.anchors.update(filter(None, (attributes.get('id'), attributes.get('name'))))
        if tag == 'a' and attributes.get('href'):
            self.links.append(attributes['href'])


def stage(folder):
    """The pages as mkdocs reads them: links out of docs/ lead to copies in project/."""
    shutil.copytree(ROOT / 'docs', folder, ignore=shutil.ignore_patterns('site', 'playground'))
    shutil.copytree(ROOT / 'docs/playground', folder / 'playground', ignore=shutil.ignore_patterns('*.mjs', '*.cpp', '*.html', '*.css', '*.cmake', '*.txt', 'scenes'))
    project = folder / 'project'
    project.mkdir()
    for page in PAGES:
        shutil.copy(ROOT / page, project / page)
    for path in folder.rglob('*.md'):
        text = path.read_text()
        if path.parent == project:
            text = text.replace('](docs/', '](../')
        else:
            def copied(match):
                source = ROOT / match[1]
                if not source.exists():
                    return match[0]
                if match[1] not in PAGES:
                    (project / match[1]).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(source, project / match[1])
                return f'](../project/{match[1]}'
            text = re.sub(r'\]\(\.\./\.\./([^)#]+)', copied, text)
        path.write_text(text)
    page, found = names.page(ROOT / 'include')
    (folder / 'reference/index-of-names.md').write_text(page)
    return found


def broken_links(site):
    """Links to anchors that are not there."""
    pages = {}
    for path in site.rglob('*.html'):
        parser = Links()
        parser.feed(path.read_text())
        pages[path.resolve()] = parser
    for path, parser in pages.items():
        for link in parser.links:
            target, _, anchor = link.partition('#')
            if re.match(r'[a-z]+:', link) or not anchor:
                continue
            other = (path.parent / target).resolve() if target else path
            other = other / 'index.html' if other.is_dir() else other
            if other not in pages or anchor not in pages[other].anchors:
                yield f'{path.relative_to(site.resolve())}: {link}'


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument('out', type=Path)
    arguments.add_argument('--playground', type=Path)
    arguments.add_argument('--header', type=Path)
    given = arguments.parse_args()
    pages, site = given.out / 'pages', given.out / 'site'
    for folder in (pages, site):
        shutil.rmtree(folder, ignore_errors=True)
    given.out.mkdir(parents=True, exist_ok=True)
    found = stage(pages)
    here = ['[the index of all public names](reference/index-of-names.md)']
    for file, place, title in ((given.playground, 'playground/graze.html', 'the playground'), (given.header, 'graze.hpp', 'graze as one header')):
        if file:
            shutil.copy(file, pages / place)
            here.append(f'[{title}]({place})')
    with (pages / 'index.md').open('a') as index:
        index.write(f'\n**In this site**: {", ".join(here)}\n')
    shutil.copy(Path(__file__).parent / 'mkdocs.yml', given.out / 'mkdocs.yml')
    result = subprocess.run(['mkdocs', 'build', '--strict', '--quiet', '--config-file', given.out / 'mkdocs.yml'], check=False)
    if result.returncode:
        sys.exit('mkdocs warns')
    broken = list(broken_links(site))
    for link in broken:
        print('leads nowhere:', link)
    missing = {'classify', 'overlaps', 'time_of_impact', 'collide', 'solve', 'ball', 'flight', 'plane', 'wall', 'triangle', 'vec', 'impact_time',
               'contact', 'wall_contact', 'encounter', 'run', 'scene', 'first_events', 'columns', 'double_word', 'error_bound',
               'try_collide', 'scene_of', 'batch::classify', 'precision::answered', 'precision::number_access'} - set(found)
    if missing:
        print('not in the index of names:', *missing)
    print(f'{len(found)} names, {sum(1 for _ in site.rglob("*.html"))} pages in {site}')
    sys.exit(1 if broken or missing else 0)


if __name__ == '__main__':
    main()
