# The front door. `make help` lists what can be asked for.
SHELL := /bin/bash
PRESET ?= release
BUILD := build/$(PRESET)
PROGRAM := $(BUILD)/rotatebook
OUT ?= out
SCENE ?= scenes/starter.toml
FUZZ_TARGETS = $(patsubst tests/fuzz/%_target.cpp,%,$(sort $(wildcard tests/fuzz/*_target.cpp)))

# Only builds with sanitizers read them.
export TSAN_OPTIONS ?= suppressions=$(CURDIR)/tests/tsan.supp
export LSAN_OPTIONS ?= suppressions=$(CURDIR)/tests/lsan.supp:print_suppressions=0:use_tls=0

.DEFAULT_GOAL := help
.PHONY: help play test-play test-play-node test-play-browsers test-readers setup setup-test configure configure-test build program figures test test-rooms fuzz coverage gallery render bench bench-peers bench-physics bench-engines record-engines format-check type-check lint textures install deb portable clean

help:
	@echo 'make figures             make every figure, comparison, study and map in $(OUT)/, each checked,'
	@echo '                         and $(OUT)/index.html, a page that shows them, with the live book once it is made;'
	@echo '                         with PNG frames of the figures; FRAMES=all: of every clip, FRAMES=no: of none'
	@echo 'make test                build and run all tests'
	@echo 'make fuzz                feed the readers with what nobody would write, SECONDS=60 or RUNS=100000 for each'
	@echo '                         (only one: TARGET=NAME; there are $(FUZZ_TARGETS))'
	@echo 'make coverage            count the lines that the tests run; a page in $(OUT)/coverage/'
	@echo 'make render SCENE=FILE   render one scene, by default $(SCENE), into $(OUT)/ (more options: ARGS="--no-png")'
	@echo 'make play                make $(OUT)/play.html, the live book, in one file'
	@echo 'make test-play           run its tests: of the core in Node, of the page in browsers'
	@echo 'make program             build $(PROGRAM)'
	@echo 'make build               build the tests and benchmarks, too'
	@echo 'make test-readers        play what is exported in three.js, glTF Transform and Blender'
	@echo 'make bench               measure frames a second by stage and end to end; two plots in $(OUT)/bench/'
	@echo 'make bench-peers         install and run the programs that make bench compares with'
	@echo 'make bench-physics       measure a step of each integrator'
	@echo 'make bench-engines       compare with Bullet, ODE, MuJoCo and Simbody: error, drift, speed'
	@echo 'make record-engines      record their motions anew in scenes/comparisons/recordings'
	@echo 'make lint                check format, compile each header alone and run the static analyser'
	@echo 'make gallery             draw docs/gallery.png and docs/pictures anew'
	@echo 'make textures            draw the cover anew (see assets/README.md)'
	@echo 'make setup               install what the program needs; other targets install what they need, too'
	@echo 'make install PREFIX=DIR   install the program, and the core as a CMake package (default /usr/local)'
	@echo 'make deb                 make a Debian package of the program, in build/deb/'
	@echo 'make portable            make a folder, and its archive, that run without anything being installed'
	@echo 'make clean               remove build/ and $(OUT)/'
	@echo 'PRESET=dev, asan-ubsan or tsan builds otherwise than optimised.'

setup:
	@scripts/setup.sh

setup-test: setup
	@scripts/setup.sh test

# CI builds all from nothing: three times as many sources at once, and fewer collections of the compiler's garbage, take
# five sixths of the time, and 1.6 GB a compiler. A preset's own flags replace CXXFLAGS.
ci_options = $(if $(filter release dev,$(PRESET)),-DROTATEBOOK_WERROR=ON) -DCMAKE_UNITY_BUILD_BATCH_SIZE=24
CONFIGURE = $(if $(CI),CXXFLAGS="$$CXXFLAGS --param=ggc-min-heapsize=1000000") cmake --preset $(PRESET) \
  $(if $(CI),$(ci_options))

# The program alone is built without what only its tests need. What needs more configures the same folder anew, and all that is
# built there stays.
configure: setup
	@test -f $(BUILD)/build.ninja || $(CONFIGURE) -DBUILD_TESTING=OFF

configure-test: setup-test
	@test -f $(BUILD)/build.ninja && grep -q '^BUILD_TESTING:BOOL=ON' $(BUILD)/CMakeCache.txt || $(CONFIGURE) -DBUILD_TESTING=ON

program: configure
	@cmake --build $(BUILD) --target rotatebook

build: configure-test
	@cmake --build $(BUILD)

# The live book, whatever PRESET says. Emscripten runs scripts that Debian keeps there, with Debian's node or another.
PLAY = NODE_PATH=/usr/share/nodejs cmake --build build/play
play: setup
	@scripts/setup.sh play
	@cmake --preset play >/dev/null
	@$(PLAY) --target live_book
	@mkdir -p $(OUT)
	cp build/play/play.html $(OUT)/play.html

test-play: test-play-node test-play-browsers

test-play-node: play
	@scripts/setup.sh play-test
	@cmake --preset play -DBUILD_TESTING=ON >/dev/null
	@$(PLAY)
	ctest --test-dir build/play --output-on-failure --no-tests=error
	node tests/browser/node/motions.cjs build/play tests/same_bits/motions.txt scenes

# BROWSERS="text motions": only those of the tests.
test-play-browsers: program play
	@scripts/setup.sh play-test
	tests/browser/player/run $(CURDIR)/$(PROGRAM) $(CURDIR)/build/play/play.html $(CURDIR)/build/play/browser $(BROWSERS)

# What is exported, played by other programs; READERS=npm or blender: only those.
READERS ?= npm blender
test-readers: program
	@scripts/setup.sh $(READERS)
	@for readers in $(READERS); do \
	  tests/app/picture/interchange/readers/run $(CURDIR)/$(PROGRAM) $(CURDIR)/build/readers $$readers || exit 1; done

PREFIX ?= /usr/local
install: program
	cmake --install $(BUILD) --prefix $(PREFIX)

# For the system that it is made on, and those with the same libraries. All its times are the last commit's; so is its
# maintainer, unless Debian's variables name another.
deb: export DEBFULLNAME ?= $(shell git log -1 --format=%an)
deb: export DEBEMAIL ?= $(shell git log -1 --format=%ae)
deb: program
	@scripts/setup.sh deb
	@rm -f build/deb/*.deb
	SOURCE_DATE_EPOCH=$$(git log -1 --format=%ct) cpack --config $(BUILD)/CPackConfig.cmake \
	  -D CPACK_PACKAGE_CONTACT="$$DEBFULLNAME <$$DEBEMAIL>" -B build/deb

# On Debian 12, whose glibc is the oldest that it then runs with.
portable: program
	@scripts/setup.sh portable
	@scripts/portable.sh $(PROGRAM) build/portable

# The page has the live book if `make play` has made it.
LIVE = $(wildcard build/play/live_book.html)
figures: program
	$(PROGRAM) render scenes/figures/*.toml -o $(OUT) --resume --overwrite$(if $(filter no,$(FRAMES)), --no-png)
	$(PROGRAM) render scenes/comparisons/*.toml scenes/bodies/*.toml -o $(OUT) --resume --overwrite$(if $(filter all,$(FRAMES)),, --no-png)
	$(PROGRAM) study scenes/studies/*.toml -o $(OUT)
	$(PROGRAM) map scenes/maps/*.toml -o $(OUT) --resume --overwrite
	$(PROGRAM) still scenes/stills/fig01-axes.toml --time 0 -o $(OUT)/fig01-axes.png
	$(PROGRAM) still scenes/stills/bound-in-maps.toml --time 0 -o $(OUT)/bound-in-maps.png
	$(PROGRAM) page scenes/comparisons/axes.toml scenes/stills/*.toml scenes/figures/*.toml scenes/comparisons/*.toml scenes/bodies/*.toml \
	  scenes/studies/*.toml scenes/maps/*.toml -o $(OUT) $(LIVE:%=--live %)

# The picture at the top of docs/figures.md: views that say what there is, small enough for a page.
gallery: program
	$(PROGRAM) still scenes/stills/fig01-axes.toml scenes/figures/fig05-unstable-x.toml \
	  scenes/figures/figa-exact.toml scenes/figures/fig12-quaternion-pulsating.toml \
	  scenes/figures/fig06-undamped.toml scenes/comparisons/models.toml \
	  --count 1 --columns 3 --size 640x360 --no-caption -o docs/gallery.png
	@scripts/setup.sh play
	scripts/pictures.sh $(PROGRAM)

# One more at a time than there are processors: the browser's test and the cluster's wait for most of their time.
test: build
	@scripts/setup.sh page || \
	  echo 'make test: going on; the test of the page will say what it lacks' >&2
	@ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j$$(($$(nproc) + 1)); status=$$?; \
	  awk '/ Testing: / {test = $$3} /: Skipped$$/ {getline; print "skipped: " test ": " $$0}' \
	  $(BUILD)/Testing/Temporary/LastTest.log; exit $$status

empty :=
space := $(empty) $(empty)
# ROOMS="scene image" FILTER='Png*': some rooms' tests, or some of those. PART='_[12]': of a room with shards, these.
test-rooms: configure-test
	@cmake --build $(BUILD) --target $(ROOMS:%=%_tests)
	@GTEST_FILTER='$(or $(FILTER),*)' ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j$$(nproc) \
	  -R '^($(subst $(space),|,$(strip $(ROOMS))))$(or $(PART),(_[0-9]+)?)$$'

# In a folder of its own, whatever PRESET says: clang's, with sanitizers. What it learns stays in build/fuzz/corpus.
fuzz: setup-test
	@scripts/setup.sh fuzz
	@cmake --preset fuzz >/dev/null
	@cmake --build --preset fuzz
	@for run in build/fuzz/tests/fuzz/run-$(or $(TARGET),*); do \
	  $$run $(if $(RUNS),-runs=$(RUNS),-max_total_time=$(or $(SECONDS),60)) || exit 1; done

render: program
	$(PROGRAM) render $(SCENE) -o $(OUT) $(ARGS)

# ARGS="--repetitions 5", "--no-plots" and so on: bench/speed.py --help
bench: program setup-test
	python3 bench/speed.py --program $(PROGRAM) -o $(OUT)/bench $(ARGS)

# The programs that `make bench` compares with, once each.
bench-peers: setup
	@scripts/setup.sh peers
	@mkdir -p build/peers
	$(CXX) -std=c++20 -O2 bench/peers/mujoco_box.cpp -o build/peers/mujoco_box -lmujoco -lEGL
	/usr/bin/python3 bench/peers/tumbling_box.py png build/peers/moderngl-png.mp4
	/usr/bin/python3 bench/peers/tumbling_box.py raw build/peers/moderngl-raw.mp4
	build/peers/mujoco_box assets/front.png build/peers/mujoco.mp4

bench-physics: configure-test
	@cmake --build $(BUILD) --target rotatebook_physics_bench
	$(BUILD)/bench/rotatebook_physics_bench

# Optimised whatever PRESET says, and in a folder of its own: no other build looks for engines.
bench-engines: setup-test
	@scripts/setup.sh engines || \
	  echo 'make bench-engines: going on with the engines that are installed' >&2
	@cmake --preset release -B build/engines -DROTATEBOOK_ENGINES=ON >/dev/null
	@cmake --build build/engines --target rotatebook_engines_bench
	build/engines/bench/engines/rotatebook_engines_bench

# The recordings in scenes/comparisons/recordings, by the engines that are installed.
record-engines: setup-test
	@scripts/setup.sh engines
	@cmake --preset release -B build/engines -DROTATEBOOK_ENGINES=ON >/dev/null
	@cmake --build build/engines --target rotatebook_engines_bench
	build/engines/bench/engines/rotatebook_engines_bench --record scenes/comparisons/recordings

# How many of the program's lines the tests run: at least 95 %. Not run are mostly answers of cards, drivers and systems that
# a test machine lacks. Where a test limits the size of files, counters can't be written, which would be reported among the
# program's own words.
coverage: setup
	@scripts/setup.sh coverage
	@find build/coverage -name '*.gcda' -delete 2>/dev/null || true
	GCOV_ERROR_FILE=/dev/null $(MAKE) --no-print-directory test PRESET=coverage
	@mkdir -p $(OUT)/coverage
	gcovr --root . --filter src/ build/coverage --exclude-throw-branches --fail-under-line 95 --print-summary \
	  --html-details $(OUT)/coverage/index.html

format-check:
	@scripts/setup.sh lint
	clang-format --dry-run --Werror $$(git ls-files '*.cpp' '*.h')

# Of the Python package.
type-check:
	@scripts/setup.sh lint
	cd python && /usr/bin/mypy --cache-dir ../build/mypy rotatebook

# By the commands of a build that compiles each file by itself.
lint: format-check type-check
	@$(MAKE) --no-print-directory configure-test PRESET=dev
	@cmake --build build/dev --target headers_alone
	git ls-files 'src/*.cpp' | xargs -P2 -n4 clang-tidy --quiet -p build/dev \
	  --extra-arg=-Wno-unknown-warning-option

textures:
	@scripts/setup.sh textures
	python3 assets/draw_textures.py

clean:
	rm -rf build $(OUT)
