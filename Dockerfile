# The portable folder in a container:
#   make portable && docker build -t rotatebook .
#   docker run --rm -v "$PWD:/work" rotatebook render my.toml
FROM debian:12-slim
ADD build/portable/rotatebook-*-x86_64-linux.tar.xz /opt/
RUN ln -s /opt/rotatebook-*/bin/rotatebook /usr/bin/
WORKDIR /work
ENTRYPOINT ["rotatebook"]
CMD ["help"]
