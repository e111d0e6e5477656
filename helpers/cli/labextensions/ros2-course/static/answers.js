/* Colours a cell with `%%answer NAME FILE` or `%%writefile FILE` by the languages of its files: each file is parsed by the
   parser that JupyterLab's editor has for a file of that name, and what stands above the first one as Python. */

const MIME = 'text/x-ros2-course-answers';
const FILE = /^%%(?:answer[ \t]+\w+|writefile(?:[ \t]+-a)?)[ \t]+(\S+)[ \t]*$/gm;
const ALIKE = { urdf: 'xml', xacro: 'xml', cfg: 'ini' }; // suffixes that the editor does not know
const PYTHON = 'a.py';
const NAMES = [PYTHON, 'a.xml', 'a.yaml', 'a.ini', 'CMakeLists.txt'];

/** The plugin. `shared`: gives one of JupyterLab's packages. */
export async function answers(shared) {
  const [{ IEditorLanguageRegistry }, { INotebookTracker }, language, lezer, highlight] = await Promise.all(
    ['@jupyterlab/codemirror', '@jupyterlab/notebook', '@codemirror/language', '@lezer/common', '@lezer/highlight'].map(
      shared,
    ),
  );
  return {
    id: 'ros2-course:answers',
    description: 'Colours cells with files by the languages of the files.',
    autoStart: true,
    requires: [IEditorLanguageRegistry, INotebookTracker],
    activate: (_, registry, tracker) => {
      // Without waiting: the parsers come over the network, and JupyterLab can start meanwhile.
      known(registry).then((parsers) => {
        const support = new language.LanguageSupport(cellLanguage(parsers, language, lezer, highlight));
        registry.addLanguage({ name: 'files of the ROS 2 course', mime: MIME, support });
        tracker.widgetAdded.connect((_, panel) => watch(panel));
        tracker.forEach(watch);
      });
    },
  };
}

/** The parsers of the editor, by the language's name. */
async function known(registry) {
  const parsers = new Map();
  for (const name of NAMES) {
    const found = registry.findByFileName(name);
    const loaded = found && (await registry.getLanguage(found));
    if (loaded?.support) {
      parsers.set(found.name, loaded.support.language.parser);
    }
  }
  return { of: (path) => parsers.get(registry.findByFileName(like(path))?.name) ?? null };
}

function like(path) {
  const name = path.split('/').pop();
  const suffix = name.split('.').pop();
  return ALIKE[suffix] ? `a.${ALIKE[suffix]}` : name;
}

/** What a text is made of: [kind, begin, end, file] of each line that names a file and of what stands between them. */
function parts(text) {
  const found = [];
  let begin = 0;
  let file = PYTHON;
  for (const line of text.matchAll(FILE)) {
    found.push(['File', begin, line.index, file], ['Line', line.index, line.index + line[0].length, '']);
    begin = Math.min(text.length, line.index + line[0].length + 1);
    file = line[1];
  }
  found.push(['File', begin, text.length, file]);
  return found.filter(([, from, to]) => from < to);
}

/** A language whose parser finds the parts of a cell, and lets the parser of each file go on. */
function cellLanguage(parsers, language, lezer, highlight) {
  const data = language.defineLanguageFacet({});
  const cell = lezer.NodeType.define({ id: 0, name: 'Cell', top: true, props: [[language.languageDataProp, data]] });
  const kinds = {
    File: lezer.NodeType.define({ id: 1, name: 'File' }),
    Line: lezer.NodeType.define({
      id: 2,
      name: 'Line',
      props: [highlight.styleTags({ Line: highlight.tags.meta })],
    }),
  };

  class Cell extends lezer.Parser {
    createParse(input, fragments, ranges) {
      const found = parts(input.read(0, input.length));
      const children = found.map(([kind, from, to]) => new lezer.Tree(kinds[kind], [], [], to - from));
      const tree = new lezer.Tree(cell, children, found.map(([, from]) => from), input.length);
      const parse = { parsedPos: input.length, stoppedAt: null, stopAt: () => {}, advance: () => tree };
      const nest = (node) => {
        const part = node.type === kinds.File && found.find(([, from]) => from === node.from);
        const parser = part && parsers.of(part[3]);
        return parser ? { parser } : null;
      };
      return lezer.parseMixed(nest)(parse, input, fragments, ranges);
    }
  }
  return new language.Language(data, new Cell(), [], 'ros2-course-answers');
}

/** Give the language to the cells of a notebook that hold files, whenever they get another one. */
function watch(panel) {
  panel.context.ready.then(() => {
    const seen = new WeakSet();
    const cells = panel.context.model.cells;
    const look = () => {
      for (const model of cells) {
        if (model.type !== 'code' || seen.has(model)) {
          continue;
        }
        seen.add(model);
        const choose = () => {
          if (model.mimeType !== MIME && model.sharedModel.getSource().search(FILE) >= 0) {
            model.mimeType = MIME;
          }
        };
        model.mimeTypeChanged.connect(choose);
        model.contentChanged.connect(choose);
        choose();
      }
    };
    cells.changed.connect(look);
    look();
  });
}
