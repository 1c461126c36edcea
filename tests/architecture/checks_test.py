#!/usr/bin/python3
"""The checks of this folder find what they are for, and nothing else."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent


def run(check, files, table):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / 'table.txt').write_text(table)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        done = subprocess.run([sys.executable, HERE / check, root, root / 'table.txt'], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


class Arrows(unittest.TestCase):
    TABLE = 'core:\nagents/methods: core\nserver: core agents/methods\n'

    def test_allowed_includes_pass(self):
        files = {'server/a.cpp': '#include "core/ids.hpp"\n#include <vector>\n#include "server/a.hpp"\n', 'core/x.hpp': ''}
        self.assertEqual(run('check_arrows.py', files, self.TABLE), (0, ''))

    def test_an_include_against_the_arrow_fails_and_is_named(self):
        code, text = run('check_arrows.py', {'core/x.hpp': '#include "server/service.hpp"\n'}, self.TABLE)
        self.assertEqual(code, 1)
        self.assertIn('core/x.hpp: core may not include server/service.hpp', text)

    def test_a_subfolder_belongs_to_its_nearest_room(self):
        code, text = run('check_arrows.py', {'agents/methods/floor/f.cpp': '#include "server/s.hpp"\n'}, self.TABLE)
        self.assertEqual(code, 1)

    FOLDERS = 'server/base:\nserver/traffic: server/base\nserver/dispatcher: server/base server/traffic\nserver: server/base server/dispatcher\n'

    def test_folders_of_one_program_have_arrows_of_their_own(self):
        files = {'server/dispatcher/d.hpp': '#include "server/traffic/t.hpp"\n', 'server/s.cpp': '#include "server/dispatcher/d.hpp"\n',
                 'server/base/b.hpp': '#include "server/base/config.hpp"\n'}
        self.assertEqual(run('check_arrows.py', files, self.FOLDERS), (0, ''))

    def test_an_include_back_up_within_one_program_fails_and_is_named(self):
        for name, included, used in (('server/traffic/t.hpp', 'server/dispatcher/d.hpp', 'server/dispatcher'),
                                     ('server/base/context.hpp', 'server/service.hpp', 'server'),
                                     ('server/s.cpp', 'server/traffic/t.hpp', 'server/traffic')):
            code, text = run('check_arrows.py', {name: f'#include "{included}"\n'}, self.FOLDERS)
            self.assertEqual(code, 1, name)
            self.assertEqual(text, f'{name}: {name.rpartition("/")[0]} may not include {included} ({used})\n')

    def test_a_new_folder_beside_listed_ones_has_to_be_listed(self):
        code, text = run('check_arrows.py', {'server/new/n.cpp': ''}, self.FOLDERS)
        self.assertEqual(code, 1)
        self.assertIn('server/new/n.cpp: its folder is no room', text)

    def test_a_typing_error_in_the_table_is_no_free_pass(self):
        self.assertNotEqual(run('check_arrows.py', {}, 'core:\nserver: cor\n')[0], 0)


class Outside(unittest.TestCase):
    TABLE = 'pcl/: agents/clouds/one.cpp tests/bench/\n'

    def test_a_library_is_included_by_its_own_room_alone(self):
        files = {'agents/clouds/one.cpp': '#include <pcl/point_types.h>\n', 'tests/bench/b.cpp': '#include <pcl/point_types.h>\n',
                 'core/a.cpp': '#include "core/pcl.hpp"\n#include <vector>\n'}
        self.assertEqual(run('check_outside.py', files, self.TABLE), (0, ''))

    def test_an_include_elsewhere_fails_and_is_named(self):
        for name in ('agents/clouds/two.cpp', 'agents/clouds/one.hpp', 'tests/agents/t.cpp'):
            code, text = run('check_outside.py', {name: '# include <pcl/point_types.h>\n'}, self.TABLE)
            self.assertEqual(code, 1, name)
            self.assertIn(f'{name}: may not include pcl/point_types.h', text)

    def test_a_library_without_a_room_is_no_free_pass(self):
        self.assertNotEqual(run('check_outside.py', {}, 'pcl/:\n')[0], 0)


class Deciding(unittest.TestCase):
    TABLE = 'core\n-core/edge\n'

    def test_each_effect_is_found(self):
        for line in ('auto t = std::chrono::steady_clock::now();', 'std::jthread worker;', 'std::mt19937 g;', 'int r = rand ();',
                     'std::unordered_map<int, int> m;', 'std::ifstream in;'):
            self.assertEqual(run('lint_deciding.py', {'core/a.cpp': line}, self.TABLE)[0], 1, line)

    def test_comments_edges_and_lookalikes_pass(self):
        files = {'core/a.cpp': '// no steady_clock here\nint operand(int);\nint x = operand(3);\n', 'core/edge/b.cpp': 'std::thread t;'}
        self.assertEqual(run('lint_deciding.py', files, self.TABLE), (0, ''))


class Sizes(unittest.TestCase):
    TABLE = 'core: 2 12\n-core/edge\n'

    def check(self, *lines):
        return run('check_sizes.py', {'core/a.hpp': '\n'.join(lines) + '\n'}, self.TABLE)

    def test_a_class_with_too_many_members_fails_and_is_named(self):
        code, text = self.check('namespace n {', 'class A final : public B<int> {', ' public:', '  int f() const;', ' private:',
                                '  int one_ = f(1, 2);', '  std::map<int, int> two_{{1, 2}};', '  B& three_;', '};', '}')
        self.assertEqual(code, 1)
        self.assertEqual(text, 'core/a.hpp:2: A has 3 data members, more than 2: give parts of it a class\n')

    def test_each_name_of_a_declaration_counts(self):
        self.assertEqual(self.check('struct A {', '  double x = 0.0, y{1, 2}, z;', '};')[0], 1)

    def test_what_is_no_data_member_does_not_count(self):
        for line in ('A(int a, int b) : one_(a), two_{b} {}', 'bool operator==(const A&) const = default;', 'enum class E { a, b, c };',
                     'static constexpr int kMost = 3;', 'using Map = std::map<int, int>;', 'friend class B;', 'class Inner;', '// int three;',
                     'struct Inner {', 'template <class T>\nvoid f(T t) { t = 1; }', 'std::vector<int> f() const { return {1, 2}; }'):
            end = ' int a, b; };' if line.endswith('{') else ''
            self.assertEqual(self.check('struct A {', line + end, 'int one_;', 'std::function<void(int, int)> two_;', '};'), (0, ''), line)

    def test_members_within_functions_and_of_the_edge_do_not_count(self):
        files = {'core/a.cpp': 'void f() {\n  int a;\n  int b;\n  int c;\n}\n', 'core/edge/b.hpp': 'struct B { int a, b, c; };\n'}
        self.assertEqual(run('check_sizes.py', files, self.TABLE), (0, ''))

    def test_a_file_with_too_many_lines_fails(self):
        code, text = self.check(*['int f();'] * 13)
        self.assertEqual((code, text), (1, 'core/a.hpp: 13 lines, more than 12: split what it does\n'))

    def test_a_typing_error_in_the_table_is_no_free_pass(self):
        self.assertNotEqual(run('check_sizes.py', {}, 'core: many 3\n')[0], 0)


class Docs(unittest.TestCase):
    TREE = {'core/time.cpp': 'void wind_up(int) {}\nclass BigClock { void tick(); };\n', 'docs/other.md': ''}

    def check(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, content in {**self.TREE, 'README.md': text}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(content)
            done = subprocess.run([sys.executable, HERE / 'check_docs.py', root], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def test_what_exists_passes(self):
        text = ('`core/time.cpp`, `core/`, core/time.cpp, time.cpp, `core/time.cpp:wind_up`, `wind_up()`, `BigClock::tick`, `BigClock`\n'
                '[there](docs/other.md#part) [web](https://example.org/x) `std::string` `a/b` `goal send`\n'
                '```\n`core/gone.cpp`\n```\n')
        self.assertEqual(self.check(text), (0, ''))

    def test_what_does_not_exist_is_named_with_its_line(self):
        for term in ('`core/gone.cpp`', 'core/gone.cpp', '(gone.hpp)', '`core/time.cpp:wind_down`', '`wind_down()`',
                     '`BigClock::strike`', '`SmallClock`', '`no_such_thing`', '[there](docs/gone.md)'):
            code, text = self.check(f'# Words\n{term}\n')
            self.assertEqual(code, 1, term)
            self.assertTrue(text.startswith('README.md:2: '), text)


class MethodNames(unittest.TestCase):
    METHODS = {'agents/methods/floor/floor.hpp': 'class Floor {};\n', 'agents/methods/recognition/index.hpp': ''}

    def check(self, files):
        for folder in ('core', 'server', 'agents/navigation', 'agents/agent'):
            files = {f'{folder}/empty.hpp': '', **files}
        return run('check_method_names.py', {**self.METHODS, **files}, '')

    def test_what_is_no_method_passes(self):
        text = 'double floor_m = std::floor(x);  // "floor" in a comment\nwrite("a floor of its own");\n'
        self.assertEqual(self.check({'server/a.cpp': text}), (0, ''))

    def test_a_name_a_class_or_a_folder_of_a_method_is_named(self):
        for text in ('if (method == "floor") {}', 'choice("method", {"floor,other"});', 'Floor::make(x);',
                     '#include "agents/methods/floor/content.hpp"', 'std::variant<Floor> any;'):
            code, said = self.check({'agents/navigation/n.cpp': text + '\n'})
            self.assertEqual(code, 1, text)
            self.assertIn('agents/navigation/n.cpp:1: ', said)

    def test_the_tool_of_one_method_may_name_it(self):
        self.assertEqual(self.check({'agents/agent/process/calibrate/m.cpp': 'Floor::make(x);\n'}), (0, ''))


class Words(unittest.TestCase):
    GLOSSARY = ('# Glossary\n\n## Words that are not used\n\n| not | but | in |\n|---|---|---|\n'
                '| "sway", "coming_back" | attitude | everywhere |\n| "Ground" | traffic map | server |\n')

    def check(self, files):
        return run('check_words.py', files, self.GLOSSARY)

    def test_other_words_comments_and_texts_pass(self):
        text = '// It sways; sway.\nlog("sway");\nint swayed;\nstd::sway x;\nint ground;\n'
        self.assertEqual(self.check({'agents/a.cpp': text, 'clients/ground.cpp': 'class Ground {};\n'}), (0, ''))

    def test_a_rejected_word_is_named_with_what_to_say(self):
        for name, text in (('agents/a.cpp', 'double keyframe_sway = 0;'), ('core/a.hpp', 'struct SwayPrior {};'),
                           ('agents/a.hpp', 'class ComingBack {};'), ('server/a.hpp', 'class Ground {};'), ('core/sway.hpp', '')):
            code, said = self.check({name: text + '\n'})
            self.assertEqual(code, 1, text)
            self.assertIn(f'{name}:', said)
            self.assertIn('docs/glossary.md; say ', said)

    def test_a_glossary_without_the_table_is_no_free_pass(self):
        self.assertNotEqual(run('check_words.py', {}, '## Words that are not used\n')[0], 0)


class NoDepth(unittest.TestCase):
    ROOM = 'agents/bodies/sim/'
    LISTED = {ROOM + 'base.hpp': 'double distance_to(const Box& box);\ndouble distance_to_rim(const Pose2& pose);\n',
              ROOM + 'scene.hpp': '  float distance(const Ray& ray) const {\n', ROOM + 'hall/ceiling_canvas.hpp': 'double depth_m() const;\n',
              ROOM + 'hall/quad_scene.hpp': 'float distance_m(const Eigen::Vector3f& eye) const;\n',
              ROOM + 'hall/hall_camera.hpp': '/// For judges.\ndouble distance_m(int column) const;\n',
              ROOM + 'hall/hall_camera.cpp': 'return hall_->scene().distance_m(eye);\n',
              'agents/perception/view.hpp': 'struct View {\n  std::variant<Image, StereoPair, Payload> data;\n};\n'}

    def check(self, files):
        return run('check_no_depth.py', self.LISTED | files, '')

    def test_what_is_listed_for_another_purpose_or_for_judges_passes(self):
        files = {'agents/methods/a.cpp': '// body.distance_m(3)\nconst double m = distance_m(relation);\n', 'clients/judge.cpp': 'camera.distance_m(3);\n'}
        self.assertEqual(self.check(files), (0, ''))

    def test_a_function_that_tells_depth_is_named(self):
        for line in ('Image depth_image() const;', 'std::vector<float> disparities(const Moment& moment);', 'double range_at(int column);',
                     'virtual float\n    true_depth(int column) const = 0;', 'const Matrix& distances() const { return all_; }'):
            code, text = self.check({self.ROOM + 'new.hpp': line + '\n'})
            self.assertEqual(code, 1, line)
            self.assertIn(self.ROOM + 'new.hpp:1: ', text)

    def test_an_agent_that_asks_as_judges_do_is_named(self):
        for name in ('agents/bodies/sim/sim_body.cpp', 'agents/methods/a.hpp'):
            code, text = self.check({name: '\nx = camera_->distance_m(3);\n'})
            self.assertEqual((code, text), (1, f'{name}:2: asks for a true distance, which is for judges alone\n'))

    def test_a_view_that_holds_more_than_images_is_named(self):
        code, text = self.check({'agents/perception/view.hpp': 'std::variant<Image, DepthImage> data;\n'})
        self.assertEqual(code, 1)
        self.assertIn('a view holds DepthImage', text)

    def test_an_empty_room_and_a_stale_list_are_no_free_pass(self):
        self.assertNotEqual(run('check_no_depth.py', {}, '')[0], 0)
        code, text = self.check({self.ROOM + 'scene.hpp': ''})
        self.assertEqual(code, 1)
        self.assertIn('scene.hpp: distance() is listed', text)


class MessagesOnce(unittest.TestCase):
    TREE = {'idl/bus/message_list.hpp': '// rows\nWEFT_TOPIC(hello, Hello, .depth = 1)\nWEFT_TOPIC(\n    chunk_up, Chunk, .depth = 1)\n'
                                        'WEFT_TOPIC(chunk_down, Chunk, .depth = 2)\n#undef WEFT_TOPIC\n',
            'idl/messages/session.idl': 'module idl {\n@final struct Hello {};\n@final struct Chunk {};\nstruct ChunkOfAnother {};\n};\n',
            'idl/convert/session.hpp': 'void describe(msg::Hello&, idl::Hello&);  // not idl::Chunk\nvoid describe(msg::Chunk&, idl::Chunk&);\n',
            'idl/bus/link.cpp': 'void greet(const msg::Hello&);\nmsg::Header header;\n',
            'server/s.cpp': 'void on(const msg::Chunk&);\n'}

    def check(self, files):
        return run('check_messages_once.py', {**self.TREE, **files}, '')

    def test_each_message_once_passes(self):
        self.assertEqual(self.check({}), (0, ''))

    def test_a_second_list_is_found_where_it_is(self):
        for text in ('case 1: return decoded<idl::Chunk>();', 'TopicId operator()(const msg::Chunk&);', '&weft_idl_Chunk_desc,'):
            code, said = self.check({'idl/bus/other.cpp': '\n' + text + '\n'})
            self.assertEqual((code, said), (1, 'idl/bus/other.cpp:2: lists Chunk by hand: fold idl/bus/message_list.hpp\n'), text)

    def test_a_message_has_one_visitor_and_one_structure(self):
        code, said = self.check({'idl/convert/more.cpp': 'idl::Chunk to_idl(const msg::Chunk&);\n'})
        self.assertEqual(code, 1)
        self.assertIn('the visitor of Chunk in idl/convert stands 2 times, not once: idl/convert/more.cpp:1, idl/convert/session.hpp:2', said)
        code, said = self.check({'idl/messages/session.idl': '@final struct Hello {};\n'})
        self.assertEqual((code, said), (1, 'the structure of Chunk in idl/messages stands 0 times, not once\n'))

    def test_programs_do_not_know_what_the_idl_makes(self):
        code, said = self.check({'server/t.cpp': 'idl::Chunk chunk;\n'})
        self.assertEqual(code, 1)
        self.assertIn('server/t.cpp:1: knows what the IDL makes of Chunk', said)

    def test_an_empty_list_is_no_free_pass(self):
        self.assertNotEqual(self.check({'idl/bus/message_list.hpp': '// nothing\n'})[0], 0)


class OwnNames(unittest.TestCase):
    LISTING = 'weft_room(weft_core\n  SOURCES a.cpp  # (first)\n    sub/b.cpp)\n'

    def check(self, a, b, listing=LISTING, scope='weft'):
        within = ['namespace %s {\nnamespace {\n%s}  // namespace\n}  // namespace %s\n' % (name, text, name)
                  for name, text in (('weft', a), (scope, b))]
        files = {'core/CMakeLists.txt': listing, 'core/a.cpp': within[0], 'core/sub/b.cpp': within[1]}
        return run('check_own_names.py', files, '')

    def test_a_name_of_two_files_of_one_target_is_named_with_both_places(self):
        before = 'int first() {\n  return 1;\n}\n'
        code, text = self.check(before + 'constexpr int kSide = 1;\n', 'double kSide{2.0};\n')
        self.assertEqual(code, 1)
        self.assertEqual(text, 'core/sub/b.cpp:3: weft::kSide is another thing in core/a.cpp:6, and weft_core compiles them '
                               'as one; rename one, or write once what both mean\n')

    def test_each_kind_of_name_is_found(self):
        for a, b in (('struct Row {\n  int a;\n};\n', 'class Row;\n'), ('int at(int x) {\n}\n', 'long at(const int& y);\n'),
                     ('const int at[2] = {1, 2};\n', 'int at(int x) {\n}\n'), ('using Row = int;\n', 'using Row = double;\n'),
                     ('}\nnamespace s = std;\nnamespace {\n', 'namespace s = weft;\n'), ('using a::Row;\n', 'using b::Row;\n'),
                     ('}\nstatic int at() {\n}\nnamespace {\n', 'int at() {\n}\n'), ('enum class E { a };\n', 'struct E {};\n'),
                     ('template <class T>\nT at(T x = f(1, 2)) {\n}\n', '[[noreturn]] int at(T y) {\n}\n')):
            self.assertEqual(self.check(a, b)[0], 1, a)

    def test_what_can_stand_beside_one_another_passes(self):
        for a, b in (('int at(int x) {\n}\n', 'int at(std::map<int, int> x, int y);\n'), ('using Row = int;\n', 'using Row = int;\n'),
                     ('struct A {\n  int side;\n};\n', 'struct B {\n  int side;\n};\n'), ('int f() {\n  int x = 1;\n}\n', 'int x = 1;\n'),
                     ('const char* a = R"(\nint side = 1;\n)";\n', 'int side = 1;\n'), ('// int side = 1;\n', 'int side = 1;\n'),
                     ('bool operator==(A, A) {\n}\n', 'bool operator==(B, B) {\n}\n'), ('TEST(A, B) {\n}\n', 'TEST(A, B) {\n}\n'),
                     ('}\nint A::at() {\n}\nnamespace {\n', 'int at() {\n}\n')):
            self.assertEqual(self.check(a, b), (0, ''), a)

    def test_names_of_other_namespaces_and_targets_and_of_files_compiled_alone_pass(self):
        same = 'int side = 1;\n'
        self.assertEqual(self.check(same, same, scope='weft::server'), (0, ''))
        self.assertEqual(self.check(same, same, 'weft_room(a SOURCES a.cpp)\nweft_test(b SOURCES sub/b.cpp)\n'), (0, ''))
        alone = 'set_source_files_properties(sub/b.cpp PROPERTIES COMPILE_OPTIONS "-O3")\n'
        self.assertEqual(self.check(same, same, self.LISTING + alone), (0, ''))
        self.assertEqual(self.check(same, same)[0], 1)

    def test_no_target_is_no_free_pass(self):
        self.assertNotEqual(run('check_own_names.py', {}, '')[0], 0)


if __name__ == '__main__':
    unittest.main()
