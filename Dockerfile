# The command line with everything it needs; `--build-arg BASE=` takes a CUDA image, for --device cuda:0.
#   docker build -t esg .
#   docker build -t esg:cuda --build-arg BASE=nvidia/cuda:12.8.1-runtime-ubuntu24.04 .
#   docker run --rm -v "$PWD/runs:/work/runs" esg generate "A ball rolls off a table."
#   docker build -t esg:dask --build-arg EXTRAS=[dask] .    # or [ray], for --runner
ARG BASE=python:3.12-slim-bookworm
FROM ${BASE}

SHELL ["/bin/bash", "-o", "pipefail", "-c"]
# hadolint ignore=DL3008
RUN apt-get update \
    && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends g++ python3 python3-venv \
    && rm -rf /var/lib/apt/lists/*

WORKDIR /opt/esg
COPY constraints.txt pyproject.toml README.md LICENSE ./
COPY esg esg
COPY tasks tasks
COPY flows flows
ARG EXTRAS=
RUN python3 -m venv /opt/venv \
    && /opt/venv/bin/pip install --no-cache-dir -c constraints.txt ".${EXTRAS}"

# Kernels and class runtime are compiled once, here: the first scene does not wait for them.
ENV PATH=/opt/venv/bin:$PATH ESG_CACHE_DIR=/opt/cache PYTHONUNBUFFERED=1
RUN useradd --create-home --uid 1000 esg && mkdir -p /opt/cache /work && chown esg /opt/cache /work
USER 1000
RUN esg setup
WORKDIR /work
ENTRYPOINT ["esg"]
CMD ["--help"]
