# The portable bundle in an image (docs/bundle.md): docker build -t castaway . where castaway-VERSION-linux-x86_64.tar.zst lies.
ARG BASE=debian:12-slim

FROM ${BASE} AS unpacked
ARG ARCHIVE=castaway-*-linux-x86_64.tar.zst
RUN apt-get update && apt-get install -y --no-install-recommends zstd
COPY ${ARCHIVE} /archive/
RUN tar --zstd --no-same-owner -xf /archive/*.tar.zst -C /opt

FROM ${BASE}
COPY --from=unpacked /opt/castaway /opt/castaway
RUN useradd --create-home --uid 1000 castaway && install -d -o castaway -g castaway /work
ENV PATH=/opt/castaway/bin:$PATH
USER castaway
WORKDIR /work
ENTRYPOINT ["castaway"]
